// What does a scene file say, before its shapes are expanded into walls?
#pragma once

#include <array>
#include <cstdint>
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
    bool operator==(const ArcShape&) const = default;
};

using Geometry = std::variant<SegmentShape, PolylineShape, PolygonShape, BoxShape, CircleShape, ArcShape>;

/// Names in files, parallel to the alternatives of Geometry.
inline constexpr std::array<std::string_view, std::variant_size_v<Geometry>> kShapeKinds{
    "segment", "polyline", "polygon", "box", "circle", "arc"};

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

/// Everything in file order.
struct SceneDescription {
    std::string title;
    Rgb environment{0.0};  ///< radiance, W / (m rad)
    std::vector<NamedMaterial> materials;
    std::vector<Shape> shapes;
    std::vector<DeltaLight> lights;  ///< directions as written, any length but zero
    bool operator==(const SceneDescription&) const = default;
};

}  // namespace halfdisk
