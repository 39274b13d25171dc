#include "surface.h"

#include "half_circle.h"
#include "overload.h"

namespace halfdisk {
namespace {

// Both directions must leave the flat wall, and the round thing, upwards.
bool isAbove(const SurfacePoint& at, Vec2 direction) {
    return glm::dot(at.N, direction) > 0.0 && glm::dot(at.round, direction) > 0.0;
}

// The facet's cosine stands in every integral; the round thing's is meant.
double cosineRatio(const SurfacePoint& at, Vec2 toLight) {
    return at.round == at.N ? 1.0 : glm::dot(at.round, toLight) / glm::dot(at.N, toLight);
}

// A ray that the round thing sends just below its own facet would be lost in it: it is mirrored up. On a
// circle of n facets that concerns the last pi/n rad before grazing.
Vec2 onSide(Vec2 direction, Vec2 N, bool above) {
    const double height = glm::dot(direction, N);
    if ((height > 0.0) == above) return direction;
    return direction - 2.0 * height * N;
}

bool isTransmitted(const SurfacePoint& at, Vec2 direction) {
    return std::holds_alternative<Dielectric>(*at.material) && glm::dot(direction, at.N) < 0.0;
}

// How likely a mirror or glass is followed.
double specularShareOf(const SurfacePoint& at) {
    const auto* mix = std::get_if<Mix>(at.material);
    if (mix) return specularShare(*mix);
    return isSpecular(*at.material) ? 1.0 : 0.0;
}

// Of a direction over the half-disk, all of which are alike.
double pdfHalfDiskOf(const SurfacePoint& at) {
    return (1.0 - specularShareOf(at)) / kPi;
}

std::optional<Scattered> sampleHalfDiskOf(const SurfacePoint& at, Carried carried, double u) {
    const double cosTheta = halfCircleCos(kPi * u), sinTheta = halfCircleSin(kPi * u);
    Scattered way{frameFromNormal(at.N).toWorld(cosTheta, sinTheta), pdfHalfDiskOf(at), Rgb(0.0)};
    const Rgb brdf = carried == Carried::radiance ? evalSurface(at, way.direction, at.from)
                                                  : evalSurface(at, at.from, way.direction);
    way.weight = brdf * (sinTheta / way.pdfAngle);
    return way;
}

// Most walls are flat and matt: they are spared all questions that only others raise. Null if it is another.
const Diffuse* flatMattWall(const SurfacePoint& at) {
    const auto* wall = std::get_if<Diffuse>(at.material);
    return wall && !at.isRound ? wall : nullptr;
}

// All other walls. Out of line, so that matt ones need not make room for what these need.
[[gnu::noinline]] Rgb evalOther(const SurfacePoint& at, Vec2 toLight, Vec2 toEye) {
    if (!isAbove(at, toLight) || !isAbove(at, toEye)) return Rgb(0.0);
    const auto brdf =
        std::visit(Overload{[](const Diffuse& wall) { return evalDiffuse(wall); },
                            [](const Mirror&) { return Rgb(0.0); },
                            [&](const Glossy& wall) { return evalGlossy(wall, at.round, toLight, toEye); },
                            [](const Dielectric&) { return Rgb(0.0); },
                            [&](const Mix& wall) { return evalMix(wall, at.round, toLight, toEye); }},
                   *at.material);
    return brdf * cosineRatio(at, toLight);
}

[[gnu::noinline]] double pdfOther(const SurfacePoint& at, Vec2 from, Vec2 to, Directions directions) {
    if (!isAbove(at, from) || !isAbove(at, to)) return 0.0;
    if (directions == Directions::halfDisk) return pdfHalfDiskOf(at);
    return std::visit(
        Overload{[&](const Diffuse&) { return pdfDiffuse(at.round, to); }, [](const Mirror&) { return 0.0; },
                 [&](const Glossy& wall) { return pdfGlossy(wall, at.round, from, to); },
                 [](const Dielectric&) { return 0.0; },
                 [&](const Mix& wall) { return pdfMix(wall, at.round, from, to); }},
        *at.material);
}

[[gnu::noinline]] std::optional<Scattered> sampleOther(const SurfacePoint& at, Carried carried,
                                                       const ScatterDraws& draws, Directions directions) {
    const double coin = draws.coin, u = draws.u, v = draws.v;
    // A mirror's part is not drawn but followed.
    if (directions == Directions::halfDisk && coin >= specularShareOf(at))
        return sampleHalfDiskOf(at, carried, u);
    auto drawn = std::visit(
        Overload{[&](const Diffuse& wall) { return std::optional(sampleDiffuse(wall, at.round, u)); },
                 [&](const Mirror& wall) { return std::optional(sampleMirror(wall, at.round, at.from)); },
                 [&](const Glossy& wall) { return sampleGlossy(wall, at.round, at.from, u, v); },
                 [&](const Dielectric& glass) {
                     const bool outside = at.front;
                     auto way = sampleDielectric(glass, at.round, at.from, outside, carried, coin);
                     const bool reflected = glm::dot(way.direction, at.round) > 0.0;
                     way.direction = onSide(way.direction, at.N, reflected);
                     return std::optional(way);
                 },
                 [&](const Mix& wall) { return sampleMix(wall, at.round, at.from, coin, u, v); }},
        *at.material);
    if (!drawn || drawn->isDelta()) {
        if (drawn && !std::holds_alternative<Dielectric>(*at.material))
            drawn->direction = onSide(drawn->direction, at.N, true);
        return drawn;
    }
    if (at.round == at.N) return drawn;
    if (!isAbove(at, drawn->direction)) return std::nullopt;
    const Rgb brdf = carried == Carried::radiance ? evalSurface(at, drawn->direction, at.from)
                                                  : evalSurface(at, at.from, drawn->direction);
    drawn->weight = brdf * (glm::dot(at.N, drawn->direction) / drawn->pdfAngle);
    return drawn;
}

}  // namespace

Vec2 roundNormalAt(const SegmentIndex& index, const Hit& hit, Vec2 from, Vec2 N) {
    const Segment& wall = index.scene().segments[hit.segment];
    const Vec2 normal = glm::normalize(wall.normalA + hit.u * (wall.normalB - wall.normalA));
    const Vec2 round = hit.front ? normal : -normal;
    return glm::dot(round, from) > 0.0 ? round : N;
}

Rgb evalSurface(const SurfacePoint& at, Vec2 toLight, Vec2 toEye) {
    if (const Diffuse* matt = flatMattWall(at))
        return glm::dot(at.N, toLight) > 0.0 && glm::dot(at.N, toEye) > 0.0 ? evalDiffuse(*matt) : Rgb(0.0);
    return evalOther(at, toLight, toEye);
}

double pdfSurface(const SurfacePoint& at, Vec2 from, Vec2 to, Directions directions) {
    if (flatMattWall(at) && directions == Directions::lobe)
        return glm::dot(at.N, from) > 0.0 && glm::dot(at.N, to) > 0.0 ? pdfDiffuse(at.N, to) : 0.0;
    return pdfOther(at, from, to, directions);
}

std::optional<Scattered> sampleSurface(const SurfacePoint& at, Carried carried, const ScatterDraws& draws,
                                       Directions directions) {
    if (directions == Directions::lobe)
        if (const Diffuse* matt = flatMattWall(at)) return sampleDiffuse(*matt, at.N, draws.u);
    return sampleOther(at, carried, draws, directions);
}

Ray leave(const SegmentIndex& index, const SurfacePoint& at, const Scattered& scattered,
          std::uint32_t speculars) {
    Ray ray{originOff(index, at.segment, at.P, scattered.direction),
            scattered.direction,
            at.segment,
            scattered.pdfAngle,
            at.medium,
            speculars};
    // Light that crosses a skin from its front is inside; one that leaves through it is outside of all glass.
    if (isTransmitted(at, scattered.direction))
        ray.medium = at.front ? index.scene().segments[at.segment].material : kNoMedium;
    return ray;
}

Vec2 originOff(const SegmentIndex& index, std::uint32_t segment, Vec2 P, Vec2 direction) {
    const Vec2 N = index.normal(segment);
    const double side = glm::dot(N, direction) < 0.0 ? -1.0 : 1.0;
    return P + N * (side * index.originShift(segment));
}

Rgb transmittanceOf(const Material& glass, double distance) {
    const Rgb& absorption = std::get<Dielectric>(glass).absorption;
    return absorption == Rgb(0.0) ? Rgb(1.0) : glm::exp(-absorption * distance);
}

std::uint32_t mediumAt(const SegmentIndex& index, Vec2 P) {
    if (!index.hasGlass()) return kNoMedium;
    const Scene& scene = index.scene();
    // Any direction will do; this one is unlikely to run along a wall or through a vertex.
    const Vec2 direction = glm::normalize(Vec2(0.8191520442889918, 0.573576436351046));
    double nearest = kInfinity;
    std::uint32_t medium = kNoMedium;
    for (const Segment& skin : scene.segments) {
        if (!std::holds_alternative<Dielectric>(scene.materials[skin.material])) continue;
        const double a = cross(direction, skin.a - P), b = cross(direction, skin.b - P);
        if ((a >= 0.0) == (b >= 0.0)) continue;
        const double t = cross(skin.a - P, skin.b - skin.a) / (b - a);
        if (!(t > 0.0) || t >= nearest) continue;
        nearest = t;
        medium = b > a ? kNoMedium : skin.material;
    }
    return medium;
}

}  // namespace halfdisk
