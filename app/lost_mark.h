// How does a ray look that went wrong? The same mark on the canvas and beside its count.
#pragma once

#include "app/pen.h"
#include "app/theme.h"
#include "core/extremes/survey.h"

namespace halfdisk {

ImU32 lostColor(const Palette& palette, LostRay::How how);

/// A disk, a ring or a cross; `radius` in pixels.
void drawLostMark(const Pen& list, const Palette& palette, LostRay::How how, ImVec2 at, float radius);

}  // namespace halfdisk
