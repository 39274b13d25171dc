// How does what one person sees get onto another's screen? All of it as one short text, to be copied and
// pasted.
#pragma once

#include <string>
#include <string_view>

#include "app/app_state.h"

namespace halfdisk {

/// Lesson and step, P, settings, what makes the pictures, what is shown, the place in the recorded run, and
/// the scene if it is not the lesson's own. Letters, digits, '-', '_' and one '.': survives mails and chats.
/// The same state gives the same text.
std::string shareText(const AppState& state);

/// The state that a text describes; spaces and line ends in it do not matter. The lesson is the one of that
/// name in `lessonsFolder`. Throws InputError for a text that is damaged or of another program, and for a
/// lesson that is not there.
AppState openShared(const std::filesystem::path& lessonsFolder, std::string_view text);

/// Whether a text looks like one of these.
bool isShareText(std::string_view text);

}  // namespace halfdisk
