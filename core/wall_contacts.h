// Where do walls touch each other? There light along a wall may jump.
#pragma once

#include <vector>

#include "scene.h"
#include "stop.h"

namespace halfdisk {

/// Ends of all walls and the places where two cross, by x. O(n log n), and the pairs of walls that lie above
/// each other. Throws Stopped if `stop` says so.
std::vector<Vec2> cornersOf(const std::vector<Segment>& walls, const StopQuestion& stop = {});

/// Places on a wall where other walls end on it or cross it (up to 1e-9 of its length), and its ends: u,
/// ascending, from 0 to 1. `corners` as cornersOf gives them.
std::vector<double> contactsOf(const Segment& wall, const std::vector<Vec2>& corners);

}  // namespace halfdisk
