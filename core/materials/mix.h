// How does a wall scatter that is partly matt and partly shiny? As one or the other, by a coin.
#pragma once

#include <variant>

#include "core/materials/diffuse.h"
#include "core/materials/glossy.h"
#include "core/materials/mirror.h"

namespace halfdisk {

/// (1 - weight) of the light meets the diffuse part, `weight` of it the specular one.
struct Mix {
    Diffuse diffuse;
    std::variant<Mirror, Glossy> specular;
    double weight = 0.5;  ///< 0 ... 1
    bool operator==(const Mix&) const = default;
};

/// Share that is sent in one direction: a mirror's part.
inline double specularShare(const Mix& wall) {
    return std::holds_alternative<Mirror>(wall.specular) ? wall.weight : 0.0;
}

/// BRDF, 1/rad, of all but a mirror's part, which has none.
inline Rgb evalMix(const Mix& wall, Vec2 N, Vec2 toLight, Vec2 toEye) {
    const Rgb matt = evalDiffuse(wall.diffuse) * (1.0 - wall.weight);
    const auto* glossy = std::get_if<Glossy>(&wall.specular);
    return glossy ? matt + evalGlossy(*glossy, N, toLight, toEye) * wall.weight : matt;
}

/// 1/rad, of the draws of sampleMix that have one.
inline double pdfMix(const Mix& wall, Vec2 N, Vec2 from, Vec2 to) {
    const double matt = pdfDiffuse(N, to) * (1.0 - wall.weight);
    const auto* glossy = std::get_if<Glossy>(&wall.specular);
    return glossy ? matt + pdfGlossy(*glossy, N, from, to) * wall.weight : matt;
}

/// `coin`, u and v in (0, 1).
inline std::optional<Scattered> sampleMix(const Mix& wall, Vec2 N, Vec2 from, double coin, double u,
                                          double v) {
    const bool shiny = coin < wall.weight;
    if (const auto* mirror = std::get_if<Mirror>(&wall.specular); shiny && mirror)
        return sampleMirror(*mirror, N, from);
    std::optional<Scattered> drawn;
    if (shiny) {
        drawn = sampleGlossy(std::get<Glossy>(wall.specular), N, from, u, v);
    } else {
        drawn = sampleDiffuse(wall.diffuse, N, u);
    }
    if (!drawn) return std::nullopt;
    // Either part could have drawn it: the density is that of both.
    drawn->pdfAngle = pdfMix(wall, N, from, drawn->direction);
    if (!(drawn->pdfAngle > 0.0)) return std::nullopt;
    drawn->weight =
        evalMix(wall, N, drawn->direction, from) * (glm::dot(N, drawn->direction) / drawn->pdfAngle);
    return drawn;
}

}  // namespace halfdisk
