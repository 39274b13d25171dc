// What is in a flatland scene? Plain vectors; everything refers to everything else by index.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "environment.h"
#include "materials/material.h"
#include "math.h"

namespace halfdisk {

/// A wall from a to b (m). Its front is the side to the left of a->b; the back is opaque and black.
struct Segment {
    Vec2 a{0.0}, b{0.0};
    std::uint32_t material = 0;  ///< index into Scene::materials
    Rgb emission{0.0};           ///< radiance Le leaving the front, W / (m rad)
    bool twoSided = false;       ///< both sides scatter and emit like a front
    /// Normals of the round thing that this wall is a facet of, at a and b (front side); scattering
    /// interpolates them. Zero: the wall is flat.
    Vec2 normalA{0.0}, normalB{0.0};
    bool operator==(const Segment&) const = default;
};

/// Irradiance I cos / r at distance r: in flatland light falls off with 1 / r.
struct PointLight {
    Vec2 position{0.0};  ///< m
    Rgb intensity{1.0};  ///< I, W / rad; its power is 2 pi I
    bool operator==(const PointLight&) const = default;
};

struct DirectionalLight {
    Vec2 direction{0.0, -1.0};  ///< of travel, unit length
    Rgb irradiance{1.0};        ///< on a surface that faces it, W / m
    bool operator==(const DirectionalLight&) const = default;
};

/// A flatland pinhole camera: it sees a strip.
struct Eye {
    Vec2 position{0.0};        ///< m
    Vec2 direction{1.0, 0.0};  ///< of its middle, unit length
    double fov = kPi / 2;      ///< whole angle, rad, below pi
    bool operator==(const Eye&) const = default;
};

using DeltaLight = std::variant<PointLight, DirectionalLight>;

struct Scene {
    std::string title;
    Environment environment;  ///< what is seen where no wall is
    std::vector<Segment> segments;
    std::vector<std::string> segmentNames;  ///< parallel to `segments`
    std::vector<Material> materials;
    std::vector<std::string> materialNames;  ///< parallel to `materials`
    std::vector<DeltaLight> lights;
    std::optional<Eye> eye;
    bool operator==(const Scene&) const = default;
};

/// Unit normal on the front side of `s`: left of a->b.
inline Vec2 frontNormal(const Segment& s) {
    return perp(s.b - s.a) / glm::length(s.b - s.a);
}

inline bool isSmooth(const Segment& s) {
    return s.normalA != Vec2(0.0);
}

inline bool isEmitter(const Segment& s) {
    return s.emission != Rgb(0.0);
}

}  // namespace halfdisk
