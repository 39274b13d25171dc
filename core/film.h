// What does a sensor hold after many passes? Mean and standard error of every pixel, and what it cost.
#pragma once

#include "pixel_statistics.h"
#include "walk.h"

namespace halfdisk {

/// One pass's value of every pixel. An estimator adds to it; it starts black.
using Picture = std::vector<Rgb>;

struct Film {
    PixelStatistics pixels;  ///< of the passes' values, which are independent
    Counts counts;
    std::uint64_t passes = 0;

    void add(const Picture& picture) {
        pixels.add(picture);
        ++passes;
    }

    /// As if the passes of `later` had been added after these.
    void merge(const Film& later) {
        pixels.merge(later.pixels);
        counts.merge(later.counts);
        passes += later.passes;
    }
};

/// Adds a contribution; one that is not finite or negative is counted. Not finite ones stay out of the
/// picture, and the count tells of them.
inline void addTo(Picture& picture, std::uint32_t pixel, const Rgb& value, Counts& counts) {
    if (!isFinite(value)) {
        ++counts.nonFinite;
        return;
    }
    if (value.x < 0.0 || value.y < 0.0 || value.z < 0.0) ++counts.negative;
    picture[pixel] += value;
}

}  // namespace halfdisk
