#include "sensor.h"

#include <algorithm>

namespace halfdisk {
namespace {

double halfWidth(const Eye& eye) {
    return std::tan(eye.fov / 2.0);
}

// Where a direction meets the film, -1 (left) ... 1 (right); empty behind the eye or beside it.
std::optional<double> filmPlace(const Eye& eye, Vec2 direction) {
    const double ahead = glm::dot(eye.direction, direction);
    if (ahead <= 0.0) return std::nullopt;
    const double place = -cross(eye.direction, direction) / (ahead * halfWidth(eye));
    if (!(std::abs(place) < 1.0)) return std::nullopt;
    return place;
}

Receiver inField(const Field& field, std::uint32_t pixel, double u, double v) {
    const double x = (pixel % field.width + u) / field.width, y = (pixel / field.width + v) / field.height;
    const Vec2 P{field.min.x + x * (field.max.x - field.min.x),
                 field.max.y - y * (field.max.y - field.min.y)};
    return {.weighing = Weighing::even, .at = {P, Vec2(0.0, 1.0)}, .pixel = pixel};
}

}  // namespace

std::uint32_t pixelCount(const Sensor& sensor) {
    return std::visit(Overload{[](const Probe&) { return 1u; }, [](const Look&) { return 1u; },
                               [](const EyeStrip& strip) { return strip.width; },
                               [](const Profile& profile) { return profile.bins; },
                               [](const Field& field) { return field.width * field.height; }},
                      sensor);
}

Receivers::Receivers(const Sensor& sensor, const SegmentIndex& index) : sensor_(&sensor), index_(&index) {
    if (const auto* profile = std::get_if<Profile>(&sensor)) {
        double total = 0.0;
        for (const std::uint32_t segment : profile->segments) upTo_.push_back(total += index.length(segment));
        covers_ = CoveredWalls(index, profile->segments);
    }
    if (const auto* probe = std::get_if<Probe>(&sensor); probe && probe->at.segment != kNoSegment)
        covers_ = CoveredWalls(index, {&probe->at.segment, 1});
}

Receiver Receivers::onProfile(const Profile& profile, std::uint32_t bin, double u) const {
    const double along = (bin + u) / profile.bins * upTo_.back();
    const auto wall = std::lower_bound(upTo_.begin(), upTo_.end() - 1, along) - upTo_.begin();
    const auto place = static_cast<std::size_t>(wall);
    const std::uint32_t segment = profile.segments[place];
    const double before = place == 0 ? 0.0 : upTo_[place - 1];
    const double t = std::min(1.0, (along - before) / index_->length(segment));
    return {.weighing = Weighing::cosine,
            .at = {index_->pointOn(segment, t), index_->normal(segment), segment},
            .pixel = bin};
}

Receiver Receivers::draw(std::uint32_t pixel, double u, double v) const {
    const SegmentIndex& index = *index_;
    Receiver receiver =
        std::visit(Overload{[](const Probe& probe) { return Receiver{.at = probe.at}; },
                            [](const Look& look) {
                                return Receiver{.weighing = Weighing::one,
                                                .at = {look.position, look.direction},
                                                .direction = look.direction};
                            },
                            [&](const EyeStrip& strip) {
                                return Receiver{.weighing = Weighing::film,
                                                .at = {strip.eye.position, strip.eye.direction},
                                                .pixel = pixel,
                                                .strip = &strip};
                            },
                            [&](const Profile& profile) { return onProfile(profile, pixel, u); },
                            [&](const Field& field) { return inField(field, pixel, u, v); }},
                   *sensor_);
    const Vec2 P = receiver.at.segment == kNoSegment
                       ? receiver.at.P
                       : originOff(index, receiver.at.segment, receiver.at.P, receiver.at.N);
    receiver.at.medium = mediumAt(index, P);
    receiver.covered = covers_.isCovered(index, receiver.at);
    return receiver;
}

std::optional<Receiver> fixedReceiver(const Sensor& sensor, const SegmentIndex& index) {
    if (!std::holds_alternative<Probe>(sensor) && !std::holds_alternative<EyeStrip>(sensor))
        return std::nullopt;
    return Receivers(sensor, index).draw(0, 0.5, 0.5);
}

Response responseTo(const Receiver& receiver, Vec2 direction) {
    if (receiver.covered) return {};
    switch (receiver.weighing) {
        case Weighing::cosine:
            return {receiver.pixel, std::max(0.0, glm::dot(receiver.at.N, direction))};
        case Weighing::even:
            return {receiver.pixel, 1.0};
        case Weighing::one:
            return {};
        case Weighing::film:
            break;
    }
    // x = tan(angle) / tan(fov / 2) on the film, so dx = d angle / (cos^2(angle) tan(fov / 2)); a pixel is 2
    // / width wide.
    const EyeStrip& strip = *receiver.strip;
    const auto place = filmPlace(strip.eye, direction);
    if (!place) return {};
    const double across = (*place + 1.0) / 2.0 * strip.width;
    const double cosine = glm::dot(strip.eye.direction, direction);
    return {std::min(static_cast<std::uint32_t>(across), strip.width - 1),
            strip.width / (2.0 * cosine * cosine * halfWidth(strip.eye))};
}

Sight sightFrom(const Receiver& receiver, const SegmentIndex& index, double u) {
    switch (receiver.weighing) {
        case Weighing::cosine: {
            const Scattered way = sampleDiffuse({Rgb(1.0)}, receiver.at.N, u);
            return {rayFrom(index, receiver.at, way.direction, way.pdfAngle), 2.0};
        }
        case Weighing::even: {
            const Vec2 direction{std::cos(2.0 * kPi * u), std::sin(2.0 * kPi * u)};
            return {rayFrom(index, receiver.at, direction, 1.0 / (2.0 * kPi)), 2.0 * kPi};
        }
        case Weighing::film: {
            const Eye& eye = receiver.strip->eye;
            const double place = 2.0 * (receiver.pixel + u) / receiver.strip->width - 1.0;
            const Vec2 right{eye.direction.y, -eye.direction.x};
            const Vec2 direction = glm::normalize(eye.direction + place * halfWidth(eye) * right);
            return {rayFrom(index, receiver.at, direction), 1.0};
        }
        case Weighing::one:
            break;
    }
    return {rayFrom(index, receiver.at, receiver.direction), 1.0};
}

double pdfSight(const Receiver& receiver, Vec2 direction) {
    if (receiver.weighing == Weighing::cosine) return pdfDiffuse(receiver.at.N, direction);
    return receiver.weighing == Weighing::even ? 1.0 / (2.0 * kPi) : 0.0;
}

ProfileBins::ProfileBins(const Profile& profile, const SegmentIndex& index) : bins_(profile.bins) {
    startOfSegment_.assign(index.scene().segments.size(), -1.0);
    length_.assign(index.scene().segments.size(), 0.0);
    double total = 0.0;
    for (const std::uint32_t segment : profile.segments) {
        startOfSegment_[segment] = total;
        length_[segment] = index.length(segment);
        total += length_[segment];
    }
    binLength_ = total / bins_;
}

std::optional<BinPlace> ProfileBins::at(std::uint32_t segment, double u) const {
    if (startOfSegment_[segment] < 0.0) return std::nullopt;
    const double along = (startOfSegment_[segment] + u * length_[segment]) / binLength_;
    return BinPlace{std::min(static_cast<std::uint32_t>(along), bins_ - 1), binLength_};
}

std::vector<Vec2> placesOf(const Sensor& sensor) {
    return std::visit(Overload{[](const Probe& probe) { return std::vector{probe.at.P}; },
                               [](const Look& look) { return std::vector{look.position}; },
                               [](const EyeStrip& strip) { return std::vector{strip.eye.position}; },
                               [](const Profile&) { return std::vector<Vec2>{}; },
                               [](const Field& field) {
                                   return std::vector{field.min, field.max};
                               }},
                      sensor);
}

}  // namespace halfdisk
