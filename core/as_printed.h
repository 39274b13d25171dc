// What does the published listing return as it is printed? castRay once more, with each of its defects behind
// a switch.
//
// With every switch off this is cast_ray.h to the bit (a test holds it to that); the switches are the entries
// of kDefects. The listing's other slips have no run-time effect of their own or do not compile: N and P are
// declared twice, the call passes a direction for a normal, the sum runs to N, the count of rays leaves out
// the lower levels, two spellings of one variable, nothing for walls that emit.
#pragma once

#include "tracing.h"

namespace halfdisk {

using std::uint32_t;

template <class Observer = NoObserver>
struct AsPrinted : Tracing<Observer> {
    using Tracing<Observer>::scene, Tracing<Observer>::settings, Tracing<Observer>::see,
        Tracing<Observer>::rays, Tracing<Observer>::cut;

    Radiance castRay(const Ray& ray, uint32_t depth, const Rng& rng);
    Irradiance gatherLight(const ShadedPoint& at, uint32_t depth, const Rng& rng, SampleRange range);
    Radiance followSpecular(const SurfacePoint& met, double coin, uint32_t speculars, uint32_t depth,
                            const Rng& rng);
    double shadowRay(const ShadedPoint& at, const LightSample& light, Vec2 towards);

    bool printed(Defect defect) const { return settings.defects.has(defect); }
    Ray leave(const ShadedPoint& at, Vec2 direction, double pdfAngle) const;
};

// [listing]
template <class Observer>
Radiance AsPrinted<Observer>::castRay(const Ray& ray, uint32_t depth, const Rng& rng) {  // 001
    const Hit hit = scene.closestHit(ray);
    see.meet(ray, hit, depth, ++rays);
    if (!hit) return {scene.environment(ray.direction)};
    const SurfacePoint met = surfaceAt(scene, ray, hit);
    if (!actsThere(scene, met)) return {};
    const Rgb clear = transmittance(scene, ray.medium, hit.t);
    const Rgb emitted = emittedTo(scene, ray, hit, settings.emitters) * clear;
    const double coin = coinOf(met, rng);
    if (isSpecularFor(met, coin)) {  // a mirror or glass: it gathers nothing, the ray goes on
        const Radiance beyond = followSpecular(met, coin, ray.speculars + 1, depth, rng);
        return {emitted + beyond.emitted * clear, beyond.scattered * clear};
    }
    if (depth > settings.maxDepth) return {emitted};  // 002
    const ShadedPoint at = shadedPointAt(met, coin);
    const Irradiance arriving = gatherLight(at, depth, rng, SampleRange::all(settings.samples));
    return {emitted, arriving.total() * clear * at.albedo / (printed(Defect::albedo) ? kPi : 2.0)};  // 033
}  // 034

template <class Observer>
Irradiance AsPrinted<Observer>::gatherLight(const ShadedPoint& at, uint32_t depth, const Rng& rng,
                                            SampleRange range) {
    const Vec2 P = at.P, N = at.N;                                                 // 003
    Rgb directLightContrib{0.0}, metLightContrib{0.0}, indirectLightContrib{0.0};  // 004
    see.enter(at, depth);
    // compute direct illumination
    for (uint32_t i = 0; i < lightCount(scene); ++i) {  // 006
        const SampleRange draws = drawsOf(scene, i, settings.emitters, range);
        UniformRow places(rng, 1 + i);
        for (uint32_t n = draws.first; n < draws.last && see.keepGoing(); ++n) {
            const double u = drawUnit(settings, places, n, draws.N);
            const LightSample light = sampleLight(scene, i, P, u);
            const Vec2 L = printed(Defect::lightsign) ? -light.L : light.L;  // 007
            Rgb L_i = light.L_i * transmittance(scene, at.medium, light.distance) *
                      (weightOf(light, settings, at) * favour(at.lobe, N, L));         // 008
            if (printed(Defect::falloff) && isPoint(scene, i)) L_i *= light.distance;  // I, not I / r
            const double visible = shadowRay(at, light, L);
            directLightContrib += visible * std::max(0.0, dot(N, L)) * L_i / draws.size();  // 010
            see.light(i, n, light, visible, directLightContrib);
        }
    }  // 011
    // compute indirect illumination
    UniformRow angles(rng, 0);
    const Frame rotMat =
        printed(Defect::frame) ? Frame{{{N.y, -N.x}, {N.x, N.y}}} : frameFromNormal(N);  // 013
    for (uint32_t n = range.first; n < range.last && see.keepGoing(); ++n) {             // 015
        // step 1: draw a random sample in the half-disk
        const auto [theta, pdfAngle] = drawHalfDisk(settings, at, angles, n, range.N);  // 017
        if (theta <= 0.0 || theta >= kPi) continue;    // the part of a lobe that the wall cuts off
        const double cosTheta = halfCircleCos(theta);  // 018
        const double sinTheta = halfCircleSin(theta);  // 019
        see.sample(n, theta, pdfAngle);
        // step 2: rotate the sample direction
        const Vec2 direction = rotMat.toWorld(cosTheta, sinTheta);  // 021
        const Ray ray = leave(at, direction, pdfAngle);
        see.direction(n, ray);
        // step 3: cast the ray into the scene
        const Radiance sampleColor = castRay(ray, depth + 1, rng.child(n));  // 024
        see.arrival(n, ray, sampleColor);
        // steps 4 and 5: treat the returned colour as if it was a light
        const double cosine = printed(Defect::cosine) ? cosTheta : sinTheta;
        const double weight =
            (printed(Defect::pdf) ? cosine : cosine / pdfAngle) * favour(at.lobe, N, direction);
        metLightContrib += sampleColor.emitted * weight;
        indirectLightContrib += sampleColor.scattered * weight;  // 027
        see.accumulate(n, sampleColor.total() * weight, metLightContrib + indirectLightContrib);
    }  // 028
    // step 6: divide by the number of samples
    metLightContrib /= range.size();
    indirectLightContrib /= range.size();  // 030
    see.average(metLightContrib + indirectLightContrib);
    const Irradiance gathered{directLightContrib + metLightContrib, indirectLightContrib};
    see.leave(at, gathered);
    return gathered;
}

template <class Observer>
double AsPrinted<Observer>::shadowRay(const ShadedPoint& at, const LightSample& light, Vec2 L) {
    if (dot(at.N, L) <= 0.0 || light.L_i == Rgb(0.0)) return 0.0;
    ++rays;
    return scene.occluded(leave(at, light.L, 0.0), light.distance, light.segment) ? 0.0 : 1.0;
}

// As printed, a ray starts at the rounded point itself and may meet its own wall. And a ray that a wrong
// frame sends below the surface meets that wall at once.
template <class Observer>
Ray AsPrinted<Observer>::leave(const ShadedPoint& at, Vec2 direction, double pdfAngle) const {
    if (printed(Defect::offset)) return {at.P, direction, kNoSegment, pdfAngle};
    Ray ray = rayFrom(scene, at, direction, pdfAngle);
    if (dot(at.N, direction) < 0.0) ray.skip = kNoSegment;
    return ray;
}

template <class Observer>
Radiance AsPrinted<Observer>::followSpecular(const SurfacePoint& met, double coin, uint32_t speculars,
                                             uint32_t depth, const Rng& rng) {
    if (speculars > settings.maxSpecular) {
        ++cut;
        return {};
    }
    const auto way = sampleSurface(met, Carried::radiance, {coin, 0.5, 0.5});
    const Radiance beyond =
        castRay(halfdisk::leave(scene, met, *way, speculars), depth, rng.child(kOwnSample));
    return {beyond.emitted * way->weight, beyond.scattered * way->weight};
}
// [end]

}  // namespace halfdisk
