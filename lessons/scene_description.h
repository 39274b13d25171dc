// What does a scene file say, before its shapes are expanded into walls?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/math.h"
#include "core/scene.h"
#include "core/settings.h"

namespace halfdisk {

/// Which way the fronts of a closed or round shape look: away from its middle, or towards it.
enum class Facing : std::uint8_t { out, in };

inline constexpr std::array<Named<Facing>, 2> kFacings{{
    {Facing::out, "out", "the fronts look away from the middle: a solid thing"},
    {Facing::in, "in", "the fronts look towards the middle: a room"},
}};

/// One wall; its front is the side to the left of a->b.
struct SegmentShape {
    Vec2 a{0.0}, b{0.0};
    bool operator==(const SegmentShape&) const = default;
};

/// Edge k runs from points[k] to points[k + 1].
struct PolylineShape {
    std::vector<Vec2> points;
    bool operator==(const PolylineShape&) const = default;
};

/// As a polyline, and closed: clockwise points face outward, counter-clockwise ones inward.
struct PolygonShape {
    std::vector<Vec2> points;
    bool operator==(const PolygonShape&) const = default;
};

/// Edges 0 ... 3 are bottom, right, top, left, whichever way they face.
struct BoxShape {
    Vec2 min{0.0}, max{0.0};
    Facing facing = Facing::out;
    bool operator==(const BoxShape&) const = default;
};

/// Edge k spans the angles 2 pi k / segments ... 2 pi (k + 1) / segments, whichever way it faces.
struct CircleShape {
    Vec2 center{0.0};
    double radius = 0.0;
    std::uint32_t segments = 0;
    Facing facing = Facing::out;
    bool smooth = false;  ///< walls scatter with the circle's own normals
    bool operator==(const CircleShape&) const = default;
};

/// From angle `from` to angle `to` (degrees), counter-clockwise if `to` is the larger, else clockwise; at
/// most one full turn. Edges are numbered from `from` on, whichever way they face.
struct ArcShape {
    Vec2 center{0.0};
    double radius = 0.0;
    double from = 0.0, to = 0.0;
    std::uint32_t segments = 0;
    Facing facing = Facing::out;
    bool smooth = false;  ///< walls scatter with the circle's own normals
    bool operator==(const ArcShape&) const = default;
};

/// A closed shape of two round surfaces, fronts outside. Seen with the axis to the right its edges run
/// clockwise: up the surface at -axis, along the upper rim, down the surface at +axis, along the lower rim. A
/// flat surface is one edge; where the surfaces meet at the rim, the rim's edges are left out.
struct LensShape {
    Vec2 center{0.0};
    Vec2 axis{1.0, 0.0};     ///< any length but zero
    double height = 0.0;     ///< across the axis (m): the aperture
    double thickness = 0.0;  ///< along the axis (m), in the middle
    Vec2 radius{0.0};        ///< of curvature (m), of the surface at -axis and of that at +axis: above 0 it
                             ///< bulges, below 0 it is hollow, 0 is flat
    std::uint32_t segments = 0;  ///< of each round surface
    bool smooth = false;         ///< round surfaces scatter with the circles' own normals
    bool operator==(const LensShape&) const = default;
};

using Geometry =
    std::variant<SegmentShape, PolylineShape, PolygonShape, BoxShape, CircleShape, ArcShape, LensShape>;

/// Names in files, parallel to the alternatives of Geometry.
inline constexpr std::array<std::string_view, std::variant_size_v<Geometry>> kShapeKinds{
    "segment", "polyline", "polygon", "box", "circle", "arc", "lens"};

struct Shape {
    std::string name;  ///< empty: expandScene makes one up ("segment1", "box1", ...)
    Geometry geometry;
    std::string material;  ///< empty: "default"
    Rgb emission{0.0};     ///< radiance leaving the front, W / (m rad)
    bool twoSided = false;
    bool operator==(const Shape&) const = default;
};

struct NamedMaterial {
    std::string name;
    Material material;
    bool operator==(const NamedMaterial&) const = default;
};

/// A shape without a material uses the material of this name; where the file has none, it is diffuse with
/// albedo 0.8.
inline constexpr std::string_view kDefaultMaterial = "default";

/// What is seen where no wall is.
struct Sky {
    Environment light;
    std::string image;  ///< the picture that light.strip came from, as written; empty: the file lists it
    bool operator==(const Sky&) const = default;
};

struct EyeDescription {
    Vec2 position{0.0};        ///< m
    Vec2 direction{1.0, 0.0};  ///< of its middle, any length but zero
    double fov = 90.0;         ///< whole angle, degrees
    bool operator==(const EyeDescription&) const = default;
};

/// Everything in file order. A mix has its parts, whatever the file calls them.
struct SceneDescription {
    std::string title;
    Sky environment;
    std::vector<NamedMaterial> materials;
    std::vector<Shape> shapes;
    std::vector<DeltaLight> lights;  ///< directions as written, any length but zero
    std::optional<EyeDescription> eye;
    bool operator==(const SceneDescription&) const = default;
};

}  // namespace halfdisk
