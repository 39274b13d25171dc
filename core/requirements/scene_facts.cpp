#include "core/requirements/scene_facts.h"

#include <algorithm>

#include "core/nearest_wall.h"
#include "core/overload.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

double most(const Rgb& c) {
    return std::max({c.x, c.y, c.z});
}

bool isGrey(const Rgb& c) {
    return c.x == c.y && c.y == c.z;
}

bool isGreyMaterial(const Material& material) {
    return std::visit(Overload{[](const Diffuse& wall) { return isGrey(wall.albedo); },
                               [](const Mirror& wall) { return isGrey(wall.reflectance); },
                               [](const Glossy& wall) { return isGrey(wall.albedo); },
                               [](const Dielectric& wall) { return isGrey(wall.absorption); },
                               [](const Mix& wall) {
                                   const auto* mirror = std::get_if<Mirror>(&wall.specular);
                                   const auto* glossy = std::get_if<Glossy>(&wall.specular);
                                   return isGrey(wall.diffuse.albedo) &&
                                          isGrey(mirror ? mirror->reflectance : glossy->albedo);
                               }},
                      material);
}

void addMaterial(const Material& material, SceneFacts& facts) {
    std::visit(
        Overload{
            [&](const Diffuse& wall) { facts.mostAlbedo = std::max(facts.mostAlbedo, most(wall.albedo)); },
            [&](const Mirror& wall) {
                ++facts.mirrors;
                facts.mostReflectance = std::max(facts.mostReflectance, most(wall.reflectance));
            },
            [&](const Glossy& wall) {
                ++facts.glossy;
                facts.mostExponent = std::max(facts.mostExponent, wall.exponent);
                facts.mostAlbedo = std::max(facts.mostAlbedo, most(wall.albedo));
            },
            [&](const Dielectric&) { ++facts.glass; },
            [&](const Mix& wall) {
                ++facts.mixes;
                Rgb scattered = wall.diffuse.albedo * (1.0 - wall.weight);
                if (const auto* glossy = std::get_if<Glossy>(&wall.specular)) {
                    ++facts.glossy;
                    facts.mostExponent = std::max(facts.mostExponent, glossy->exponent);
                    scattered += glossy->albedo * wall.weight;
                } else {
                    ++facts.mirrors;
                    const Rgb mirrored = std::get<Mirror>(wall.specular).reflectance * wall.weight;
                    facts.mostReflectance = std::max(facts.mostReflectance, most(mirrored));
                    // What is mirrored comes to such walls again, until it is scattered.
                    for (int c = 0; c < 3; ++c)
                        if (mirrored[c] < 1.0) scattered[c] /= 1.0 - mirrored[c];
                }
                facts.mostAlbedo = std::max(facts.mostAlbedo, most(scattered));
            }},
        material);
}

bool isMirrorWall(const Scene& scene, const Segment& wall) {
    const Material& material = scene.materials[wall.material];
    const auto* mix = std::get_if<Mix>(&material);
    return std::holds_alternative<Mirror>(material) || (mix && std::holds_alternative<Mirror>(mix->specular));
}

// A flat mirror is left on one side of its line, and a straight ray does not come back to it: one event. Two
// flat mirrors whose lines meet at an angle alpha are a kaleidoscope: unfolded, light runs straight on across
// the mirrors' images, alpha apart, of which half a turn holds ceil(pi / alpha). A chain stays in one of the
// two wedges, so the narrower one bounds it.
void boundChain(const Scene& scene, SceneFacts& facts) {
    if (!facts.traits.specular) {
        facts.longestChain = 0;
        facts.chainReason = "no mirror and no glass";
        return;
    }
    if (facts.glass > 0) {
        facts.chainReason = "inside glass light may be reflected for ever";
        return;
    }
    std::vector<Vec2> along;
    for (const Segment& wall : scene.segments) {
        if (!isMirrorWall(scene, wall)) continue;
        if (isSmooth(wall)) {
            facts.chainReason = "mirrors are round";
            return;
        }
        along.push_back((wall.b - wall.a) / glm::length(wall.b - wall.a));
    }
    if (along.size() == 1) {
        facts.longestChain = 1;
        facts.chainReason = "one flat mirror: light that leaves it does not come back straight";
    } else if (along.size() == 2 && std::abs(cross(along[0], along[1])) > 1e-3) {
        const double angle = std::asin(std::min(1.0, std::abs(cross(along[0], along[1]))));
        facts.longestChain = static_cast<std::uint32_t>(std::ceil(kPi / angle - 1e-9)) + 1;
        facts.chainReason = words::joined("two flat mirrors, ", words::number(angle * 180.0 / kPi, 3),
                                          "° apart: a kaleidoscope of so many images");
    } else {
        facts.chainReason = "mirrors may face each other";
    }
}

double distanceTo(Vec2 P, const Segment& wall) {
    return nearestOnStretch(wall.a, wall.b, P).distance;
}

/// How far it rises above the lamp's line on the side where that shines, m.
double riseOver(const Segment& lamp, const Segment& wall) {
    const Vec2 N = frontNormal(lamp);
    const double a = glm::dot(N, wall.a - lamp.a), b = glm::dot(N, wall.b - lamp.a);
    return lamp.twoSided ? std::max(std::abs(a), std::abs(b)) : std::max(a, b);
}

bool hasLampInCorner(const Scene& scene) {
    constexpr double kNear = 0.02;                 // of the lamp's length
    constexpr std::size_t kMostPairs = 4'000'000;  // more are not looked at: taken as near
    std::vector<const Segment*> lamps;
    for (const Segment& wall : scene.segments)
        if (isEmitter(wall)) lamps.push_back(&wall);
    if (lamps.size() * scene.segments.size() > kMostPairs) return true;
    for (const Segment* lamp : lamps) {
        const double near = kNear * glm::length(lamp->b - lamp->a);
        for (const Segment& wall : scene.segments) {
            if (&wall == lamp || isSpecular(scene.materials[wall.material]) || riseOver(*lamp, wall) <= near)
                continue;
            const double gap = std::min({distanceTo(lamp->a, wall), distanceTo(lamp->b, wall),
                                         distanceTo(wall.a, *lamp), distanceTo(wall.b, *lamp)});
            if (gap <= near) return true;
        }
    }
    return false;
}

}  // namespace

SceneFacts factsOf(const Scene& scene) {
    SceneFacts facts;
    facts.traits = traitsOf(scene);
    for (const DeltaLight& light : scene.lights) {
        const auto* point = std::get_if<PointLight>(&light);
        ++(point ? facts.points : facts.suns);
        facts.grey =
            facts.grey && isGrey(point ? point->intensity : std::get<DirectionalLight>(light).irradiance);
    }
    facts.environment = scene.environment.radiance != Rgb(0.0);
    facts.grey = facts.grey && isGrey(scene.environment.radiance);
    for (const Rgb& factor : scene.environment.strip) facts.grey = facts.grey && isGrey(factor);
    for (const Segment& wall : scene.segments) {
        if (isEmitter(wall)) ++facts.lamps;
        facts.grey = facts.grey && isGrey(wall.emission) && isGreyMaterial(scene.materials[wall.material]);
        addMaterial(scene.materials[wall.material], facts);
    }
    facts.lampInCorner = hasLampInCorner(scene);
    boundChain(scene, facts);
    return facts;
}

std::optional<std::uint32_t> scatteringsUntil(double share, double tolerance) {
    if (share <= 0.0) return 0;
    if (share >= 1.0) return std::nullopt;
    const double count = std::ceil(std::log(tolerance * (1.0 - share)) / std::log(share) - 1e-9) - 1.0;
    if (count > kMaxDepthInfo.most) return std::nullopt;
    return static_cast<std::uint32_t>(std::max(0.0, count));
}

}  // namespace halfdisk
