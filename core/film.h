// What does a sensor hold after many passes? Mean and standard error of every pixel, and what it cost.
#pragma once

#include <vector>

#include "statistics.h"
#include "walk.h"

namespace halfdisk {

/// One pass's value of every pixel. An estimator adds to it; it starts black.
using Picture = std::vector<Rgb>;

struct Film {
    std::vector<Statistics> pixels;  ///< of the passes' values, which are independent
    Counts counts;
    std::uint64_t passes = 0;

    void add(const Picture& picture) {
        if (pixels.empty()) pixels.resize(picture.size());
        for (std::size_t i = 0; i < picture.size(); ++i) pixels[i].add(picture[i]);
        ++passes;
    }

    /// As if the passes of `later` had been added after these.
    void merge(const Film& later) {
        if (pixels.empty()) pixels.resize(later.pixels.size());
        for (std::size_t i = 0; i < later.pixels.size(); ++i) pixels[i].merge(later.pixels[i]);
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
