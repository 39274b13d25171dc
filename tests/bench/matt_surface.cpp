// Takes the place of core/surface.cpp in unused_features.sh: the same for flat, matt walls alone, and nothing
// else.
#include "core/surface.h"

namespace halfdisk {

Vec2 roundNormalAt(const SegmentIndex&, const Hit&, Vec2, Vec2 N) {
    return N;
}

Rgb evalSurface(const SurfacePoint& at, Vec2 toLight, Vec2 toEye) {
    if (!(glm::dot(at.N, toLight) > 0.0) || !(glm::dot(at.N, toEye) > 0.0)) return Rgb(0.0);
    return evalDiffuse(std::get<Diffuse>(*at.material));
}

double pdfSurface(const SurfacePoint& at, Vec2 from, Vec2 to, Directions directions) {
    if (!(glm::dot(at.N, from) > 0.0) || !(glm::dot(at.N, to) > 0.0)) return 0.0;
    return directions == Directions::halfDisk ? 1.0 / kPi : pdfDiffuse(at.N, to);
}

std::optional<Scattered> sampleSurface(const SurfacePoint& at, Carried, const ScatterDraws& draws,
                                       Directions) {
    return sampleDiffuse(std::get<Diffuse>(*at.material), at.N, draws.u);
}

Ray leave(const SegmentIndex& index, const SurfacePoint& at, const Scattered& scattered, std::uint32_t) {
    return {originOff(index, at.segment, at.P, scattered.direction), scattered.direction, at.segment,
            scattered.pdfAngle};
}

Vec2 originOff(const SegmentIndex& index, std::uint32_t segment, Vec2 P, Vec2 direction) {
    const Vec2 N = index.normal(segment);
    const double side = glm::dot(N, direction) < 0.0 ? -1.0 : 1.0;
    return P + N * (side * index.originShift(segment));
}

Rgb transmittanceOf(const Material&, double) {
    return Rgb(1.0);
}

std::uint32_t mediumAt(const SegmentIndex&, Vec2) {
    return kNoMedium;
}

}  // namespace halfdisk
