// Which materials are tested, and how are they looked at?
#pragma once

#include <cmath>

#include "core/surface.h"
#include "support.h"

namespace halfdisk::test {

struct MaterialRow {
    const char* name;
    Material material;
};

inline std::vector<MaterialRow> scatteringMaterials() {
    return {{"diffuse", Diffuse{Rgb(0.9, 0.5, 0.1)}},
            {"glossy 0", Glossy{Rgb(1.0), 0.0}},
            {"glossy 1", Glossy{Rgb(0.9), 1.0}},
            {"glossy 7.5", Glossy{Rgb(1.0, 0.5, 0.2), 7.5}},
            {"glossy 300", Glossy{Rgb(1.0), 300.0}},
            {"mix with a mirror", Mix{Diffuse{Rgb(0.6)}, Mirror{Rgb(0.9)}, 0.3}},
            {"mix with glossy", Mix{Diffuse{Rgb(0.6)}, Glossy{Rgb(0.9), 25.0}, 0.6}}};
}

inline std::vector<MaterialRow> allMaterials() {
    auto all = scatteringMaterials();
    all.push_back({"mirror", Mirror{Rgb(0.9, 0.8, 0.7)}});
    all.push_back({"glass", Dielectric{1.5, Rgb(0.0)}});
    all.push_back({"glass from within", Dielectric{1.5, Rgb(0.0)}});
    all.push_back({"index 1", Dielectric{1.0, Rgb(0.0)}});
    all.push_back({"index 4", Dielectric{4.0, Rgb(0.0)}});
    return all;
}

/// Unit, so far (rad) from the normal, which points up.
inline Vec2 fromNormal(double angle) {
    return {std::sin(angle), std::cos(angle)};
}

/// A wall's point, met by a ray that comes from there.
inline SurfacePoint seenAt(const Material& material, double angle, bool front = true) {
    return {Vec2(0.0), Vec2(0.0, 1.0), Vec2(0.0, 1.0), fromNormal(angle), 0,
            front,     false,          kNoMedium,      &material};
}

inline ScatterDraws drawsFrom(Random& random) {
    const double coin = random.in(0.0, 1.0), u = random.in(0.0, 1.0);
    return {coin, u, random.in(0.0, 1.0)};
}

/// rad from the normal.
inline constexpr double kIncidences[] = {0.0, 0.4, -0.9, 1.3, 1.55};

}  // namespace halfdisk::test
