// On which scenes and rays do all ways to find a wall have to agree?
#pragma once

#include <string>
#include <vector>

#include "core/intersect.h"
#include "support.h"

namespace halfdisk::test {

struct IndexCase {
    std::string name;
    Scene scene;
};

/// Random, tessellated and fractal walls; shared vertices, coincident, axis-parallel and single walls; none;
/// each of the small ones also far from the origin, tiny and huge.
std::vector<IndexCase> indexCases();

/// `count` rays of many kinds: random, along walls and axes, through vertices, off walls, from far away, with
/// very short and very long directions. Not for an empty scene.
std::vector<Ray> testRays(const SegmentIndex& index, std::size_t count, Random& random);

/// Rays that start at one place and turn from the first angle to the last: a half-disk on a wall, a narrow
/// eye, a full turn.
std::vector<std::vector<Ray>> testFans(const SegmentIndex& index, std::size_t count, Random& random);

}  // namespace halfdisk::test
