// Which wall is a point on, or nearest to?
#pragma once

#include "intersect.h"

namespace halfdisk {

struct NearestWall {
    std::uint32_t segment = kNoSegment;
    double t = 0.0;               ///< of the wall's point that is nearest, 0 at a ... 1 at b
    double distance = kInfinity;  ///< m
};

/// From a to b. One without length is a point.
NearestWall nearestOnStretch(Vec2 a, Vec2 b, Vec2 P);

/// The point of one wall that is nearest to P.
NearestWall nearestOn(const Scene& scene, std::uint32_t segment, Vec2 P);

/// Of all walls; the lower index if two are as near. kNoSegment in a scene without walls.
NearestWall nearestWall(const Scene& scene, Vec2 P);

}  // namespace halfdisk
