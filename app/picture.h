// What does the program look like in a given state? One finished frame, for screenshots and for tests.
#pragma once

#include <span>
#include <vector>

#include "app/app_state.h"
#include "app/headless_host.h"
#include "app/png_image.h"

namespace halfdisk {

/// Waits for the light to be complete, then draws. The same state and size give the same picture.
Image pictureOf(AppState state, HeadlessHost& host);

/// The same light on several screens, each at its host's scale.
std::vector<Image> picturesOf(AppState state, std::span<HeadlessHost* const> hosts);

}  // namespace halfdisk
