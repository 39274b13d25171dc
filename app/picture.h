// What does the program look like in a given state? One finished frame, for screenshots and for tests.
#pragma once

#include "app/app_state.h"
#include "app/headless_host.h"
#include "app/png_image.h"

namespace halfdisk {

/// Waits for the light to be complete, then draws. The same state and size give the same picture.
Image pictureOf(AppState state, HeadlessHost& host);

}  // namespace halfdisk
