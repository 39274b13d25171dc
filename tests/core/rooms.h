// Which rooms do the tests stand in? Builders of small scenes.
#pragma once

#include <vector>

#include "core/scene.h"

namespace halfdisk::test {

/// Adds a wall with a material of its own; returns its index.
std::uint32_t addWall(Scene& scene, Vec2 a, Vec2 b, Rgb albedo = Rgb(0.5), Rgb emission = Rgb(0.0),
                      bool twoSided = false);

/// A wall of a material that the scene has (or will have).
Segment wallOf(Vec2 a, Vec2 b, std::uint32_t material, Rgb emission = Rgb(0.0));

/// Closed polygon through `points` (counter-clockwise: it faces inward). All walls share one material.
Scene polygonRoom(const std::vector<Vec2>& points, Rgb albedo = Rgb(0.5), Rgb emission = Rgb(0.0));

/// A matt, convex box of 2 m by 1.5 m with a point light: what comes straight from that has no noise.
inline constexpr Rgb kBoxAlbedo{0.7, 0.5, 0.3};
Scene litBox();

/// Counter-clockwise vertices of a regular polygon.
std::vector<Vec2> regularPolygon(int sides, double radius = 1.0, Vec2 center = {0.0, 0.0});

/// Counter-clockwise star: not convex, 2 * `spikes` vertices.
std::vector<Vec2> starPolygon(int spikes, double inner, double outer);

/// Isosceles triangle with its sharp corner of `degrees` at the origin, sides of length 1, counter-clockwise,
/// turned by `turn` rad.
std::vector<Vec2> wedge(double degrees, double turn = 0.0);

/// Where a copy of a scene stands: scale * p + offset.
struct Placing {
    double scale;
    Vec2 offset;
};

/// scale * p + offset for every point.
std::vector<Vec2> moved(std::vector<Vec2> points, double scale, Vec2 offset);

/// The closed, not convex room of the white furnace.
std::vector<Vec2> furnacePolygon();

/// One floor, one lamp above it, a block that stands in the light, and both kinds of delta lights. Colours
/// differ by channel.
Scene mixedRoom();

}  // namespace halfdisk::test
