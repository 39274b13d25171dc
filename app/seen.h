// What is seen, to be written to files? The picture of the screen, and what canvas, plots and strips draw.
#pragma once

#include <functional>

#include "app/frame.h"
#include "app/png_image.h"
#include "app/sheet.h"

namespace halfdisk {

/// How a host draws frames that are not shown.
struct FrameMaker {
    using Draw = std::function<void()>;
    std::function<void(const Draw&)> layOut;  ///< one frame; its pixels are not needed
    std::function<void(const Draw&)> draw;    ///< one frame with its pixels
    std::function<Image()> pixels;            ///< of the last frame with pixels
    std::function<const Fonts&()> fonts;
    std::function<float()> scale;  ///< pixels per design pixel
};

struct Seen {
    Image screen;
    Sheet sheet;  ///< also of what a small screen shows only on demand
};

/// Draws some frames without pointer, help and messages; the state is then as it was. Whether the light is
/// complete is the caller's business.
Seen seenBy(Session& session, const FrameMaker& maker);

}  // namespace halfdisk
