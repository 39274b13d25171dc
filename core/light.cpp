#include "light.h"

#include <cmath>

#include "overload.h"

namespace halfdisk {
namespace {

LightSample fromPoint(const PointLight& light, Vec2 P) {
    const Vec2 way = light.position - P;
    const double r = glm::length(way);
    if (r == 0.0) return {};  // P is the light itself: no direction to speak of
    return {.L = way / r, .distance = r, .L_i = light.intensity / r};
}

LightSample fromDirection(const DirectionalLight& light) {
    return {.L = -light.direction, .L_i = light.irradiance};
}

LightSample fromSegment(const SegmentIndex& index, std::uint32_t segment, Vec2 P, double u) {
    const Segment& s = index.scene().segments[segment];
    const Vec2 way = s.a + u * (s.b - s.a) - P;
    const double r = glm::length(way);
    if (r == 0.0) return {};
    LightSample sample{.L = way / r, .distance = r, .segment = segment};
    const double cosine = -glm::dot(index.normal(segment), sample.L);
    const double facing = s.twoSided ? std::abs(cosine) : cosine;
    if (facing <= 0.0) return sample;
    sample.pdfAngle = r / (index.length(segment) * facing);
    sample.L_i = s.emission / sample.pdfAngle;
    return sample;
}

}  // namespace

std::uint32_t lightCount(const SegmentIndex& index) {
    return static_cast<std::uint32_t>(index.scene().lights.size() + index.emitters().size());
}

bool isDelta(const SegmentIndex& index, std::uint32_t light) {
    return light < index.scene().lights.size();
}

bool isPoint(const SegmentIndex& index, std::uint32_t light) {
    return isDelta(index, light) && std::holds_alternative<PointLight>(index.scene().lights[light]);
}

LightSample sampleLight(const SegmentIndex& index, std::uint32_t light, Vec2 P, double u) {
    const auto& lights = index.scene().lights;
    if (!isDelta(index, light)) return fromSegment(index, index.emitters()[light - lights.size()], P, u);
    return std::visit(Overload{[&](const PointLight& point) { return fromPoint(point, P); },
                               [&](const DirectionalLight& sun) { return fromDirection(sun); }},
                      lights[light]);
}

double pdfLight(const SegmentIndex& index, const Ray& ray, const Hit& hit) {
    const double speed = glm::length(ray.direction);
    const double cosine = std::abs(glm::dot(index.normal(hit.segment), ray.direction)) / speed;
    return hit.t * speed / (index.length(hit.segment) * cosine);
}

}  // namespace halfdisk
