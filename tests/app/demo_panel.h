// Which little screen do the tests of the plumbing operate and photograph?
#pragma once

#include <string>

#include "app/fonts.h"
#include "app/widgets.h"

namespace halfdisk {

/// One widget of every kind, and what was done to it.
struct DemoPanel {
    int clicks = 0;
    bool ticked = false, on = false;
    int choice = 0;
    int samples = 16;
    std::uint64_t seed = 1;
    double depth = 1.0;
    std::string name = "Corner";
    bool canvasHovered = false;
    WidgetRegistry registry;

    /// A whole frame: clears the registry, then a window of the host's full size with every widget and every
    /// font.
    void draw(const Fonts& fonts);
};

}  // namespace halfdisk
