// What does pulling, moving, turning and scaling do to a shape?
#pragma once

#include <vector>

#include "lessons/scene_description.h"

namespace halfdisk {

/// A vector, turned by the angle of a unit one.
inline Vec2 turned(Vec2 v, Vec2 unit) {
    return {v.x * unit.x - v.y * unit.y, v.x * unit.y + v.y * unit.x};
}

/// Points (m) by which a shape can be pulled: its ends, points or corners; of round ones the middle first.
std::vector<Vec2> handlesOf(const Geometry& geometry);

/// Pulls one of the handles to a place. What would turn the shape inside out is kept right side out.
void pullHandle(Geometry& geometry, std::size_t handle, Vec2 to);

/// What turning and scaling leave where it is (m).
Vec2 middleOf(const Geometry& geometry);

void moveBy(Geometry& geometry, Vec2 by);

/// About its middle, counter-clockwise. A box becomes a polygon unless it is a multiple of 90 degrees.
void turnBy(Geometry& geometry, double degrees);

/// About its middle; factor > 0.
void scaleBy(Geometry& geometry, double factor);

/// Front and back change places. Not of a lens, whose fronts are its outside.
void flip(Geometry& geometry);

}  // namespace halfdisk
