// How is a rendering told on the terminal, to people and to scripts?
#pragma once

#include <string>

#include "app/render_result.h"

namespace halfdisk {

/// What all pixels say together.
struct PixelSummary {
    Rgb mean{0.0};                             ///< over all pixels
    std::uint64_t lit = 0;                     ///< pixels that are not black
    std::optional<double> relativeErrorOfLit;  ///< median of standard error / mean; of channel means
};
PixelSummary summarize(const Film& film);

/// The facts of the files, then `threads`, `stopped`, `mean` over the pixels, `litPixels`, `relativeError`,
/// `raysPerSecond` and `files`.
Json renderJson(const RenderResult& result);

/// A table with units, and warnings where samples were bad or paths were cut.
std::string renderTable(const RenderResult& result);

/// Lines that say what the counts of cut paths and bad contributions mean; empty if there are none.
std::string countWarnings(const Film& film, std::uint32_t maxSpecular);

}  // namespace halfdisk
