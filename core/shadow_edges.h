// Where on the walls does a light come into sight past a corner? There what arrives jumps or bends, and a
// patch across it would smear a beam.
//
// Heckbert 1992, "Discontinuity meshing for radiosity"; of its events, those of sources without size and of
// lamps' ends.
#pragma once

#include "exact.h"

namespace halfdisk {

/// A place on one side of a wall.
struct WallPlace {
    std::uint32_t segment = kNoSegment;
    bool front = true;
    double u = 0.0;  ///< 0 at a, 1 at b
};

/// Of point lights, directional lights and the ends of lamps; to about 1e-6 of the distance. Two rays for
/// each of them and each corner. Throws Stopped if `stop` says so.
std::vector<WallPlace> shadowEdges(const Visibility& visibility, const StopQuestion& stop = {});

}  // namespace halfdisk
