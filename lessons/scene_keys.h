// Which keys does a scene file have? The one list that reading, the check for unknown keys and writing go
// through.
//
// `Io` is the reader or the writer; both offer
//   required(key, field, rule)            the key must be there
//   optional(key, field, fallback, rule)  if it is not there, or need not be: `fallback`
//   synonym(key, ofKey, field, rule, map)  another way to say `ofKey`, read through `map` and never written
#pragma once

#include <limits>

#include "lessons/scene_description.h"
#include "lessons/scene_expansion.h"
#include "lessons/sky_image.h"
#include "lessons/value_reader.h"

namespace halfdisk {

struct FlagRule {};
struct NameRule {};
struct PointsRule {
    std::size_t least;  ///< fewest points
};
/// Part of a mix: its colour, the name of a material of the file, or a table of its own.
struct PartRule {};
/// Two radii of curvature, or one for both.
struct CurvatureRule {};
/// A list of colours.
struct StripRule {
    std::size_t most;
};

inline constexpr double kAboveZero = std::numeric_limits<double>::min();
inline constexpr NumberRule kCoordinateRule{-1e9, 1e9, "a number of metres from -1e9 to 1e9"};
inline constexpr NumberRule kRadiusRule{kAboveZero, 1e9, "a number of metres above 0, at most 1e9"};
inline constexpr NumberRule kDegreesRule{-3600.0, 3600.0, "a number of degrees from -3600 to 3600"};
inline constexpr NumberRule kCurvatureRule{
    -1e9, 1e9, "a radius of curvature from -1e9 to 1e9 m (hollow below 0, flat at 0)"};
inline constexpr NumberRule kFovRule{kAboveZero, 179.0, "a number of degrees above 0, at most 179"};
inline constexpr NumberRule kShareRule{0.0, 1.0, "a number from 0 to 1"};
inline constexpr NumberRule kExponentRule{0.0, kMostExponent, "a number from 0 to 1e6"};
inline constexpr NumberRule kIorRule{1.0, 10.0, "a number from 1 to 10"};
inline constexpr NumberRule kAbsorptionRule{0.0, 1e6, "a number per metre from 0 to 1e6"};
/// Far above any physical light, and far below what would overflow in a sum.
inline constexpr NumberRule kLightRule{0.0, 1e30, "a number from 0 to 1e30"};
inline constexpr NumberRule kDirectionRule{-1e30, 1e30, "a number from -1e30 to 1e30"};
inline constexpr WholeRule kCircleSegmentsRule{3, kMaxSegments};
inline constexpr WholeRule kArcSegmentsRule{1, kMaxSegments};
/// One facet would leave nothing of a surface but its rim.
inline constexpr WholeRule kLensSegmentsRule{2, kMaxSegments};
inline constexpr TextRule kTitleRule{200};
inline constexpr TextRule kImageRule{1000, false, false};

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
    io.optional("smooth", shape.smooth, false, FlagRule{});
}

template <class Io>
void keysOf(Io& io, ArcShape& shape) {
    io.required("center", shape.center, kCoordinateRule);
    io.required("radius", shape.radius, kRadiusRule);
    io.required("from", shape.from, kDegreesRule);
    io.required("to", shape.to, kDegreesRule);
    io.required("segments", shape.segments, kArcSegmentsRule);
    io.optional("facing", shape.facing, Facing::out, kFacings);
    io.optional("smooth", shape.smooth, false, FlagRule{});
}

template <class Io>
void keysOf(Io& io, LensShape& shape) {
    io.required("center", shape.center, kCoordinateRule);
    io.optional("axis", shape.axis, LensShape{}.axis, kDirectionRule);
    io.required("height", shape.height, kRadiusRule);
    io.required("thickness", shape.thickness, kRadiusRule);
    io.required("radius", shape.radius, CurvatureRule{});
    io.required("segments", shape.segments, kLensSegmentsRule);
    io.optional("smooth", shape.smooth, false, FlagRule{});
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
    io.optional("albedo", material.albedo, Diffuse{}.albedo, kShareRule);
}

template <class Io>
void keysOf(Io& io, Mirror& material) {
    io.optional("reflectance", material.reflectance, Mirror{}.reflectance, kShareRule);
}

template <class Io>
void keysOf(Io& io, Glossy& material) {
    io.optional("albedo", material.albedo, Glossy{}.albedo, kShareRule);
    io.optional("exponent", material.exponent, Glossy{}.exponent, kExponentRule);
    io.synonym("roughness", "exponent", material.exponent, kShareRule, exponentOfRoughness);
}

template <class Io>
void keysOf(Io& io, Dielectric& material) {
    io.optional("ior", material.ior, Dielectric{}.ior, kIorRule);
    io.optional("absorption", material.absorption, Dielectric{}.absorption, kAbsorptionRule);
}

template <class Io>
void keysOf(Io& io, Mix& material) {
    io.required("diffuse", material.diffuse, PartRule{});
    io.required("specular", material.specular, PartRule{});
    io.optional("weight", material.weight, Mix{}.weight, kShareRule);
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

/// A strip is in units of the radiance, which need not be told then.
template <class Io>
void keysOf(Io& io, Sky& sky) {
    io.optional("image", sky.image, std::string(), kImageRule);
    io.optional("strip", sky.light.strip, std::vector<Rgb>(), StripRule{kMostStripEntries});
    const bool constant = sky.image.empty() && sky.light.strip.empty();
    io.optional("radiance", sky.light.radiance, Rgb(constant ? 0.0 : 1.0), kLightRule);
}

template <class Io>
void keysOf(Io& io, EyeDescription& eye) {
    io.required("position", eye.position, kCoordinateRule);
    io.required("direction", eye.direction, kDirectionRule);
    io.optional("fov", eye.fov, EyeDescription{}.fov, kFovRule);
}

/// Values of the key `type`, parallel to the alternatives of the variant.
inline constexpr std::array<Named<std::size_t>, std::variant_size_v<Material>> kMaterialTypes{{
    {0, "diffuse", "scatters evenly into the half-disk"},
    {1, "mirror", "reflects in one direction, on both sides"},
    {2, "glossy", "scatters in a lobe about the mirror direction"},
    {3, "dielectric", "glass: reflects and refracts; the inside is behind the fronts"},
    {4, "mix", "scatters in part as a diffuse wall, in part as a mirror or a glossy one"},
}};
inline constexpr std::array<Named<std::size_t>, std::variant_size_v<DeltaLight>> kLightTypes{{
    {0, "point", "shines evenly from a point, falling off with the distance"},
    {1, "directional", "shines in one direction from infinitely far away"},
}};

}  // namespace halfdisk
