// What does one light, chosen by chance, send straight to a point? Next-event estimation, and the weights by
// which two ways of finding the same light share it.
#pragma once

#include "film.h"
#include "light_table.h"
#include "sensor.h"

namespace halfdisk {

enum class Heuristic : std::uint8_t { balance, power };

/// Share of the technique with density `mine` where another with density `other` finds the same light (Veach
/// 1997, section 9.2).
inline double misWeight(Heuristic heuristic, double mine, double other) {
    // As a ratio, so that huge densities do not overflow.
    const double ratio = other / mine;
    return heuristic == Heuristic::balance ? 1.0 / (1.0 + ratio) : 1.0 / (1.0 + ratio * ratio);
}

/// One way from a point to a light.
struct DrawnLight {
    Vec2 L{0.0};  ///< unit, to the light
    Rgb L_i{
        0.0};  ///< irradiance on a surface that faces it / probability of this draw, W/m; 0 if hidden or dark
    double pdfAngle = 0.0;    ///< 1/rad, of L by this way of drawing; 0: a light with one direction
    std::uint32_t light = 0;  ///< its number
    std::uint32_t segment = kNoSegment;  ///< the lamp
    double distance = kInfinity;         ///< m
};

/// Draws a light by power and a way to it, and asks whether the way is free. `rayTo(L)` is the ray that
/// leaves the point. `matters(L)`: false spares the shadow ray, where nothing would be added.
template <class RayTo, class Matters>
DrawnLight drawLight(const LightTable& lights, Vec2 P, double pick, double u, const RayTo& rayTo,
                     const Matters& matters, Counts& counts) {
    const LightPick picked = lights.pick(pick);
    if (picked.probability == 0.0) return {};
    const LightSample way = lights.sampleFrom(picked.light, P, u);
    DrawnLight drawn{way.L,        Rgb(0.0),    way.pdfAngle * picked.probability,
                     picked.light, way.segment, way.distance};
    if (way.L_i == Rgb(0.0) || !matters(way.L)) return drawn;
    const Ray ray = rayTo(way.L);
    ++counts.rays;
    if (lights.index().occluded(ray, way.distance, way.segment)) return drawn;
    drawn.L_i = way.L_i / picked.probability;
    if (ray.medium != kNoMedium) drawn.L_i *= transmittance(lights.index(), ray.medium, way.distance);
    return drawn;
}

/// At a wall's point.
inline DrawnLight drawLight(const LightTable& lights, const SurfacePoint& at, double pick, double u,
                            Counts& counts) {
    const auto rayTo = [&](Vec2 L) {
        return Ray{originOff(lights.index(), at.segment, at.P, L), L, at.segment, 0.0, at.medium};
    };
    return drawLight(
        lights, at.P, pick, u, rayTo, [&](Vec2 L) { return glm::dot(at.N, L) > 0.0; }, counts);
}

/// At a receiver.
inline DrawnLight drawLight(const LightTable& lights, const Receiver& receiver, double pick, double u,
                            Counts& counts) {
    const auto rayTo = [&](Vec2 L) { return rayFrom(lights.index(), receiver.at, L); };
    return drawLight(
        lights, receiver.at.P, pick, u, rayTo, [&](Vec2 L) { return responseTo(receiver, L).weight > 0.0; },
        counts);
}

/// The way from a wall's point to a receiver.
struct Connection {
    Response response;      ///< of the receiver to light from there
    Vec2 toReceiver{0.0};   ///< unit, from the wall's point
    double distance = 0.0;  ///< m
    Rgb passed{0.0};        ///< share that gets through; 0 if something is in the way
};

/// Asks the way only where something would be added.
inline Connection connect(const SegmentIndex& index, const SurfacePoint& at, const Receiver& receiver,
                          Counts& counts) {
    Connection way;
    const Vec2 gap = receiver.at.P - at.P;
    way.distance = glm::length(gap);
    if (way.distance == 0.0) return way;
    way.toReceiver = gap / way.distance;
    way.response = responseTo(receiver, -way.toReceiver);
    if (way.response.weight <= 0.0 || glm::dot(at.N, way.toReceiver) <= 0.0) return way;
    const Ray ray{originOff(index, at.segment, at.P, way.toReceiver), way.toReceiver, at.segment, 0.0,
                  at.medium};
    ++counts.rays;
    if (!index.occluded(ray, way.distance, receiver.at.segment))
        way.passed = transmittance(index, at.medium, way.distance);
    return way;
}

}  // namespace halfdisk
