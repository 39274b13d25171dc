// Why can't a sensor be used?
#include <algorithm>

#include "nearest_wall.h"
#include "sensor.h"
#include "wall_kind.h"

namespace halfdisk {
namespace {

/// A wall that meets the probe's own one right there, not at an end of it: beside it and beyond it other
/// light arrives.
std::optional<std::uint32_t> wallThrough(const Probe& probe, const Scene& scene) {
    if (probe.at.segment == kNoSegment) return std::nullopt;
    constexpr double kHere = 1e-9;  // of the length
    const Segment& own = scene.segments[probe.at.segment];
    const Vec2 along = own.b - own.a;
    const double length = glm::length(along), t = nearestOnStretch(own.a, own.b, probe.at.P).t;
    if (!(t > kHere && t < 1.0 - kHere)) return std::nullopt;
    for (std::uint32_t i = 0; i < scene.segments.size(); ++i) {
        const Segment& wall = scene.segments[i];
        if (i == probe.at.segment || nearestOnStretch(wall.a, wall.b, probe.at.P).distance > kHere * length)
            continue;
        const double above =
            std::max(glm::dot(probe.at.N, wall.a - probe.at.P), glm::dot(probe.at.N, wall.b - probe.at.P));
        if (above > kHere * length) return i;
    }
    return std::nullopt;
}

}  // namespace

std::string faultOf(const Sensor& sensor, const SegmentIndex& index) {
    if (pixelCount(sensor) == 0) return "the sensor has no pixels";
    if (const auto* profile = std::get_if<Profile>(&sensor)) {
        if (profile->segments.empty()) return "the profile names no wall";
        std::vector<std::uint32_t> sorted = profile->segments;
        std::sort(sorted.begin(), sorted.end());
        if (sorted.back() >= index.scene().segments.size())
            return "the profile names a wall that does not exist";
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
            return "the profile names a wall twice";
    }
    if (const auto* probe = std::get_if<Probe>(&sensor))
        if (const auto wall = wallThrough(*probe, index.scene()))
            return quotedName(index.scene(), *wall) +
                   " stands where the probe is: other light arrives on each side of it, expected a place "
                   "beside it";
    if (const auto* field = std::get_if<Field>(&sensor))
        if (!(field->max.x - field->min.x > 1e-12 && field->max.y - field->min.y > 1e-12))
            return "the field has no area";
    if (const auto* strip = std::get_if<EyeStrip>(&sensor))
        if (!(strip->eye.fov > 0.0 && strip->eye.fov < kPi))
            return "the eye's field of view is not between 0 and 180 degrees";
    return {};
}

}  // namespace halfdisk
