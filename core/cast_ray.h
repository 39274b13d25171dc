// How much light comes back along a ray? The published castRay, with its defects mended.
//
// The number at a line's end is that line's number in the published listing. The listing's one function
// stands here as two that call each other: castRay follows a ray to the wall that it meets, gatherLight
// collects over the half-disk what arrives there. as_printed.h keeps the defects, each behind a switch.
#pragma once

#include "tracing.h"

namespace halfdisk {

using std::uint32_t;

template <class Observer = NoObserver>
struct CastRay : Tracing<Observer> {
    using Tracing<Observer>::scene, Tracing<Observer>::settings, Tracing<Observer>::see,
        Tracing<Observer>::rays, Tracing<Observer>::cut;

    /// Light back along `ray`. `depth` is 0 at the point shaded first; past maxDepth a wall emits but does
    /// not scatter.
    Radiance castRay(const Ray& ray, uint32_t depth, const Rng& rng);

    /// Light that arrives at P over the half-disk about N: the mean of the samples in `range`.
    Irradiance gatherLight(const ShadedPoint& at, uint32_t depth, const Rng& rng, SampleRange range);

    /// Light that comes back over a mirror or a skin of glass, the `speculars`-th in a row.
    Radiance followSpecular(const SurfacePoint& met, double coin, uint32_t speculars, uint32_t depth,
                            const Rng& rng);

    /// 1 if nothing stands between P and the light, else 0.
    double shadowRay(const ShadedPoint& at, const LightSample& light);
};

// [listing]
template <class Observer>
Radiance CastRay<Observer>::castRay(const Ray& ray, uint32_t depth, const Rng& rng) {  // 001
    const Hit hit = scene.closestHit(ray);
    see.meet(ray, hit, depth, ++rays);
    if (!hit) return {scene.environment(ray.direction)};  // a miss returns the environment
    const SurfacePoint met = surfaceAt(scene, ray, hit);
    if (!actsThere(scene, met)) return {};  // the back of a wall is black
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
    return {emitted, arriving.total() * clear * at.albedo / 2.0};  // 033
}  // 034

template <class Observer>
Irradiance CastRay<Observer>::gatherLight(const ShadedPoint& at, uint32_t depth, const Rng& rng,
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
            const Vec2 L = light.L;  // 007
            const Rgb L_i = light.L_i * transmittance(scene, at.medium, light.distance) *
                            (weightOf(light, settings, at) * favour(at.lobe, N, L));  // 008
            // on a diffuse wall favour is 1
            const double visible = shadowRay(at, light);
            directLightContrib += visible * std::max(0.0, dot(N, L)) * L_i / draws.size();  // 010
            see.light(i, n, light, visible, directLightContrib);
        }
    }  // 011
    // compute indirect illumination
    UniformRow angles(rng, 0);
    const Frame rotMat = frameFromNormal(N);                                  // 013
    for (uint32_t n = range.first; n < range.last && see.keepGoing(); ++n) {  // 015
        // step 1: draw a random sample in the half-disk
        const auto [theta, pdfAngle] = drawHalfDisk(settings, at, angles, n, range.N);  // 017
        if (theta <= 0.0 || theta >= kPi) continue;    // the part of a lobe that the wall cuts off
        const double cosTheta = halfCircleCos(theta);  // 018
        const double sinTheta = halfCircleSin(theta);  // 019
        see.sample(n, theta, pdfAngle);
        // step 2: rotate the sample direction
        const Vec2 direction = rotMat.toWorld(cosTheta, sinTheta);  // 021
        const Ray ray = rayFrom(scene, at, direction, pdfAngle);
        see.direction(n, ray);
        // step 3: cast the ray into the scene
        const Radiance sampleColor = castRay(ray, depth + 1, rng.child(n));  // 024
        see.arrival(n, ray, sampleColor);
        // steps 4 and 5: treat the returned colour as if it was a light
        // (theta starts at the tangent, so N.L is its sine)
        const double weight = sinTheta / pdfAngle * favour(at.lobe, N, direction);
        metLightContrib += sampleColor.emitted * weight;
        indirectLightContrib += sampleColor.scattered * weight;  // 027
        see.accumulate(n, sampleColor.total() * weight, metLightContrib + indirectLightContrib);
    }  // 028
    // step 6: divide by the number of samples
    metLightContrib /= range.size();
    indirectLightContrib /= range.size();  // 030
    see.average(metLightContrib + indirectLightContrib);
    // step 7, the albedo, is castRay's: here is what arrives
    const Irradiance gathered{directLightContrib + metLightContrib, indirectLightContrib};
    see.leave(at, gathered);
    return gathered;
}

template <class Observer>
double CastRay<Observer>::shadowRay(const ShadedPoint& at, const LightSample& light) {
    if (dot(at.N, light.L) <= 0.0 || light.L_i == Rgb(0.0)) return 0.0;  // nothing would be added
    ++rays;
    return scene.occluded(rayFrom(scene, at, light.L), light.distance, light.segment) ? 0.0 : 1.0;
}

template <class Observer>
Radiance CastRay<Observer>::followSpecular(const SurfacePoint& met, double coin, uint32_t speculars,
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
