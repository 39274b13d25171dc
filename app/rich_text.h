// How does a lesson's prose get on the screen? Wrapped words in several fonts, with terms that explain
// themselves on hover.
#pragma once

#include "app/frame.h"
#include "lessons/prose.h"

namespace halfdisk {

/// Draws `prose` across the width that is left in the current window. Each line of words is registered as a
/// text.
void richText(const Ui& ui, const Prose& prose, const std::vector<Term>& terms);

}  // namespace halfdisk
