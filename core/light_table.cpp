#include "light_table.h"

#include "nearest_wall.h"
#include "overload.h"

namespace halfdisk {
namespace {

double meanOf(const Rgb& c) {
    return (c.x + c.y + c.z) / 3.0;
}

// The entry of running sums that `u` of the last one falls into, and where in it (0 ... 1). Entries of size 0
// are never chosen.
struct Choice {
    std::size_t entry;
    double within;
};
Choice choose(const std::vector<double>& upTo, double u) {
    const double target = u * upTo.back();
    const auto entry =
        static_cast<std::size_t>(std::upper_bound(upTo.begin(), upTo.end() - 1, target) - upTo.begin());
    const double before = entry == 0 ? 0.0 : upTo[entry - 1];
    return {entry, std::clamp((target - before) / (upTo[entry] - before), 0.0, 1.0)};
}

double sizeOf(const std::vector<double>& upTo, std::size_t entry) {
    return entry == 0 ? upTo[0] : upTo[entry] - upTo[entry - 1];
}

Vec2 drawFrom(const std::vector<double>& skyUpTo, double u) {
    const Choice bin = choose(skyUpTo, u);
    const double angle =
        2.0 * kPi * (static_cast<double>(bin.entry) + bin.within) / static_cast<double>(skyUpTo.size());
    return {std::cos(angle), std::sin(angle)};
}

/// Within twice the rounding that a shadow ray's end allows for; kNoSegment: none.
std::uint32_t wallAt(const SegmentIndex& index, Vec2 P) {
    const NearestWall wall = nearestWall(index.scene(), P);
    const bool onWall = wall.segment != kNoSegment && wall.distance <= 2.0 * index.originShift(wall.segment);
    return onWall ? wall.segment : kNoSegment;
}

// Out of line: lamps, which are asked far more often, need not make room for what the sky needs.
[[gnu::noinline]] LightSample sampleSky(const LightTable& table, const std::vector<double>& skyUpTo,
                                        double u) {
    const Vec2 direction = drawFrom(skyUpTo, u);
    const double pdfAngle = table.pdfEnvironment(direction);
    // At the seam of two bins rounding may name the darker one.
    if (!(pdfAngle > 0.0)) return {.L = direction};
    return {.L = direction, .L_i = table.index().environment(direction) / pdfAngle, .pdfAngle = pdfAngle};
}

}  // namespace

LightTable::LightTable(const SegmentIndex& index, const std::vector<Vec2>& extra)
    : index_(&index), covers_(index, index.emitters()), count_(lightCount(index)) {
    const Scene& scene = index.scene();
    Vec2 low(kInfinity), high(-kInfinity);
    const auto include = [&](Vec2 point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    };
    for (const Segment& wall : scene.segments) {
        include(wall.a);
        include(wall.b);
    }
    for (const DeltaLight& light : scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light)) include(point->position);
    for (const Vec2& point : extra) include(point);
    if (low.x <= high.x) {
        center_ = (low + high) / 2.0;
        // A little more than needed: a beam's edge must not graze the outermost wall by rounding.
        radius_ = std::max(glm::length(high - low) / 2.0 * (1.0 + 1e-9), 1e-9);
    }

    for (const DeltaLight& light : scene.lights) {
        const auto* bulb = std::get_if<PointLight>(&light);
        onWall_.push_back(bulb ? wallAt(index, bulb->position) : kNoSegment);
    }
    for (const DeltaLight& light : scene.lights)
        powers_.push_back(std::visit(
            Overload{[](const PointLight& point) { return point.intensity * (2.0 * kPi); },
                     [&](const DirectionalLight& sun) { return sun.irradiance * (2.0 * radius_); }},
            light));
    for (const std::uint32_t segment : index.emitters()) {
        const Segment& lamp = scene.segments[segment];
        powers_.push_back(lamp.emission * (index.length(segment) * (lamp.twoSided ? 4.0 : 2.0)));
    }
    const Environment& sky = scene.environment;
    const std::size_t entries = std::max<std::size_t>(1, sky.strip.size());
    const double wide = 2.0 * kPi / static_cast<double>(entries);
    Rgb skyPower{0.0};
    double skySum = 0.0;
    for (std::size_t k = 0; k < entries; ++k) {
        const Rgb radiance = sky.strip.empty() ? sky.radiance : sky.radiance * sky.strip[k];
        skyPower += radiance * (wide * 2.0 * radius_);
        skySum += meanOf(radiance);
        skyUpTo_.push_back(skySum);
    }
    if (skySum > 0.0) powers_.push_back(skyPower);
    for (const Rgb& power : powers_) upTo_.push_back(total_ += meanOf(power));
}

LightPick LightTable::pick(double u) const {
    if (isDark()) return {};
    const auto [light, within] = choose(upTo_, u);
    return {static_cast<std::uint32_t>(light), sizeOf(upTo_, light) / total_, within};
}

double LightTable::probability(std::uint32_t light) const {
    return light < upTo_.size() && total_ > 0.0 ? sizeOf(upTo_, light) / total_ : 0.0;
}

Vec2 LightTable::drawEnvironment(double u) const {
    return drawFrom(skyUpTo_, u);
}

double LightTable::pdfEnvironment(Vec2 direction) const {
    const std::size_t entries = skyUpTo_.size();
    if (!(skyUpTo_.back() > 0.0)) return 0.0;
    const double share =
        sizeOf(skyUpTo_, entries == 1 ? 0 : stripIndex(entries, direction)) / skyUpTo_.back();
    return share * static_cast<double>(entries) / (2.0 * kPi);
}

LightSample LightTable::sampleFrom(std::uint32_t light, Vec2 P, double u) const {
    if (light < count_) return sampleLight(*index_, light, P, u);
    return sampleSky(*this, skyUpTo_, u);
}

double LightTable::pdfDrawn(const Ray& ray, const Hit& hit) const {
    if (!hit) return probability(environmentLight()) * pdfEnvironment(ray.direction);
    if (!isEmitter(index_->scene().segments[hit.segment])) return 0.0;
    return probability(lightOf(hit.segment)) * pdfLight(*index_, ray, hit);
}

std::uint32_t LightTable::lightOf(std::uint32_t segment) const {
    const auto& lamps = index_->emitters();
    const auto lamp = std::lower_bound(lamps.begin(), lamps.end(), segment);
    return static_cast<std::uint32_t>(index_->scene().lights.size() +
                                      static_cast<std::size_t>(lamp - lamps.begin()));
}

Ray LightTable::beam(Vec2 direction, double u) const {
    // Two radii before the centre, so that nothing lies behind the start.
    return {center_ - 2.0 * radius_ * direction + (2.0 * u - 1.0) * radius_ * perp(direction), direction};
}

double LightTable::pdfPositionOf(std::uint32_t light) const {
    const std::size_t deltas = index_->scene().lights.size();
    if (light == environmentLight() || (light < deltas && !isPoint(*index_, light)))
        return 1.0 / (2.0 * radius_);
    if (light < deltas) return 0.0;
    return 1.0 / index_->length(index_->emitters()[light - deltas]);
}

Emission LightTable::emit(double place, double v) const {
    const LightPick picked = pick(place);
    if (picked.probability == 0.0) return {};
    const double u = picked.within;
    const Scene& scene = index_->scene();
    Emission out;
    out.light = picked.light;
    out.power = powers_[picked.light] / picked.probability;
    out.pdfPosition = pdfPositionOf(picked.light);
    if (picked.light == environmentLight()) {
        const Vec2 towards = drawEnvironment(v);
        out.pdfAngle = pdfEnvironment(towards);
        out.ray = beam(-towards, u);
        out.power = out.pdfAngle > 0.0
                        ? index_->environment(towards) * (2.0 * radius_ / (out.pdfAngle * picked.probability))
                        : Rgb(0.0);
        return out;
    }
    if (picked.light >= scene.lights.size()) {
        out.segment = index_->emitters()[picked.light - scene.lights.size()];
        const bool back = scene.segments[out.segment].twoSided && v >= 0.5;
        if (scene.segments[out.segment].twoSided) v = back ? 2.0 * v - 1.0 : 2.0 * v;
        out.N = back ? -index_->normal(out.segment) : index_->normal(out.segment);
        const Scattered way = sampleDiffuse({Rgb(1.0)}, out.N, v);
        const Vec2 P = index_->pointOn(out.segment, u);
        out.ray = {originOff(*index_, out.segment, P, way.direction), way.direction, out.segment};
        out.ray.medium = mediumAt(*index_, out.ray.origin);
        out.pdfAngle = scene.segments[out.segment].twoSided ? way.pdfAngle / 2.0 : way.pdfAngle;
        if (covers_.isCovered(*index_, {P, out.N, out.segment})) out.power = Rgb(0.0);
        return out;
    }
    std::visit(Overload{[&](const PointLight& point) {
                            out.ray = {point.position, {std::cos(2.0 * kPi * u), std::sin(2.0 * kPi * u)}};
                            out.ray.medium = mediumAt(*index_, point.position);
                            out.pdfAngle = 1.0 / (2.0 * kPi);
                        },
                        [&](const DirectionalLight& sun) { out.ray = beam(sun.direction, u); }},
               scene.lights[picked.light]);
    if (onWall_[picked.light] != kNoSegment) leaveWall(onWall_[picked.light], out);
    return out;
}

// As a shadow ray has it, which comes from where the light goes.
void LightTable::leaveWall(std::uint32_t wall, Emission& light) const {
    const Vec2 bulb = light.ray.origin, direction = light.ray.direction;
    const double away = 1e-6 * radius_;
    if (index_->occluded({bulb + away * direction, -direction}, away)) light.power = Rgb(0.0);
    light.ray.origin = originOff(*index_, wall, bulb, direction);
    light.ray.skip = wall;
}

}  // namespace halfdisk
