// Which keys does a scene file have? The one list that reading, the check for unknown keys and writing go
// through.
//
// `Io` is the reader or the writer; both offer
//   required(key, field, rule)            the key must be there
//   optional(key, field, fallback, rule)  if it is not there, or need not be: `fallback`
#pragma once

#include <limits>

#include "lessons/scene_description.h"
#include "lessons/scene_expansion.h"
#include "lessons/value_reader.h"

namespace halfdisk {

struct FlagRule {};
struct NameRule {};
struct PointsRule {
    std::size_t least;  ///< fewest points
};

inline constexpr double kAboveZero = std::numeric_limits<double>::min();
inline constexpr NumberRule kCoordinateRule{-1e9, 1e9, "a number of metres from -1e9 to 1e9"};
inline constexpr NumberRule kRadiusRule{kAboveZero, 1e9, "a number of metres above 0, at most 1e9"};
inline constexpr NumberRule kDegreesRule{-3600.0, 3600.0, "a number of degrees from -3600 to 3600"};
inline constexpr NumberRule kAlbedoRule{0.0, 1.0, "a number from 0 to 1"};
/// Far above any physical light, and far below what would overflow in a sum.
inline constexpr NumberRule kLightRule{0.0, 1e30, "a number from 0 to 1e30"};
inline constexpr NumberRule kDirectionRule{-1e30, 1e30, "a number from -1e30 to 1e30"};
inline constexpr WholeRule kCircleSegmentsRule{3, kMaxSegments};
inline constexpr WholeRule kArcSegmentsRule{1, kMaxSegments};
inline constexpr TextRule kTitleRule{200};

template <class Io>
void keysOf(Io& io, SegmentShape& shape) {
    io.required("a", shape.a, kCoordinateRule);
    io.required("b", shape.b, kCoordinateRule);
}

template <class Io>
void keysOf(Io& io, PolylineShape& shape) {
    io.required("points", shape.points, PointsRule{2});
}

template <class Io>
void keysOf(Io& io, PolygonShape& shape) {
    io.required("points", shape.points, PointsRule{3});
}

template <class Io>
void keysOf(Io& io, BoxShape& shape) {
    io.required("min", shape.min, kCoordinateRule);
    io.required("max", shape.max, kCoordinateRule);
    io.optional("facing", shape.facing, Facing::out, kFacings);
}

template <class Io>
void keysOf(Io& io, CircleShape& shape) {
    io.required("center", shape.center, kCoordinateRule);
    io.required("radius", shape.radius, kRadiusRule);
    io.required("segments", shape.segments, kCircleSegmentsRule);
    io.optional("facing", shape.facing, Facing::out, kFacings);
}

template <class Io>
void keysOf(Io& io, ArcShape& shape) {
    io.required("center", shape.center, kCoordinateRule);
    io.required("radius", shape.radius, kRadiusRule);
    io.required("from", shape.from, kDegreesRule);
    io.required("to", shape.to, kDegreesRule);
    io.required("segments", shape.segments, kArcSegmentsRule);
    io.optional("facing", shape.facing, Facing::out, kFacings);
}

template <class Io>
void keysOf(Io& io, Shape& shape) {
    io.optional("name", shape.name, std::string(), NameRule{});
    std::visit([&](auto& geometry) { keysOf(io, geometry); }, shape.geometry);
    io.optional("material", shape.material, std::string(), NameRule{});
    io.optional("emission", shape.emission, Rgb(0.0), kLightRule);
    io.optional("twoSided", shape.twoSided, false, FlagRule{});
}

template <class Io>
void keysOf(Io& io, Diffuse& material) {
    io.optional("albedo", material.albedo, Diffuse{}.albedo, kAlbedoRule);
}

template <class Io>
void keysOf(Io& io, PointLight& light) {
    io.required("position", light.position, kCoordinateRule);
    io.optional("intensity", light.intensity, Rgb(1.0), kLightRule);
}

template <class Io>
void keysOf(Io& io, DirectionalLight& light) {
    io.required("direction", light.direction, kDirectionRule);
    io.optional("irradiance", light.irradiance, Rgb(1.0), kLightRule);
}

/// Values of the key `type`, parallel to the alternatives of the variant.
inline constexpr std::array<Named<std::size_t>, std::variant_size_v<Material>> kMaterialTypes{{
    {0, "diffuse", "scatters evenly into the half-disk"},
}};
inline constexpr std::array<Named<std::size_t>, std::variant_size_v<DeltaLight>> kLightTypes{{
    {0, "point", "shines evenly from a point, falling off with the distance"},
    {1, "directional", "shines in one direction from infinitely far away"},
}};

}  // namespace halfdisk
