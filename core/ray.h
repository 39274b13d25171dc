// What is a ray, and what is known of the wall that it meets?
#pragma once

#include <cstdint>
#include <limits>

#include "math.h"

namespace halfdisk {

inline constexpr std::uint32_t kNoSegment = 0xFFFFFFFF;
inline constexpr std::uint32_t kNoMedium = 0xFFFFFFFF;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ray {
    Vec2 origin;                       ///< m
    Vec2 direction;                    ///< need not be of unit length; t counts in its length
    std::uint32_t skip = kNoSegment;   ///< the straight wall that the ray leaves, which it cannot meet again
    double pdfAngle = 0.0;             ///< density (1/rad) by which a half-disk drew it; 0: aimed, not drawn
    std::uint32_t medium = kNoMedium;  ///< the glass (an index into Scene::materials) that it runs in
    std::uint32_t speculars = 0;       ///< mirror and glass events in a row that it comes from
};

struct Hit {
    std::uint32_t segment = kNoSegment;
    double t = kInfinity;  ///< along the ray, in lengths of its direction
    double u = 0.0;        ///< along the segment, 0 at a and 1 at b
    bool front = false;    ///< the ray came from the front side (left of a->b)

    explicit operator bool() const { return segment != kNoSegment; }
};

}  // namespace halfdisk
