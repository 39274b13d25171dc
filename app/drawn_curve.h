// What does the reader expect? A curve drawn by hand over the half-disk, before the exact one is shown.
#pragma once

#include "app/plot.h"

namespace halfdisk {

/// Draws it, and lets it be drawn, in a plot over degrees from the normal. Returns whether the exact curve is
/// to stay hidden.
bool drawnCurve(const Ui& ui, const Plot& plot);

}  // namespace halfdisk
