#include "recorder.h"

namespace halfdisk {

int listingLine(EventKind kind) {
    switch (kind) {
        case EventKind::enter:
            return 3;
        case EventKind::light:
            return 10;
        case EventKind::sample:
            return 17;
        case EventKind::direction:
            return 21;
        case EventKind::meet:
        case EventKind::arrival:
            return 24;
        case EventKind::accumulate:
            return 27;
        case EventKind::average:
            return 30;
        case EventKind::leave:
            return 33;
    }
    return 0;
}

Event& Recorder::append(EventKind kind) {
    const Frame& frame = open_.back();
    const Call& call = record_.calls[frame.call];
    Event event;
    event.kind = kind;
    event.call = frame.call;
    event.depth = call.depth;
    event.n = frame.n;
    event.from = call.at.P;
    return record_.events.emplace_back(event);
}

void Recorder::meet(const Ray& ray, const Hit& hit, std::uint32_t, std::uint64_t rays) {
    record_.rays = rays;
    if (omitted()) return;
    Frame& frame = open_.back();
    const Vec2 to = ray.origin + ray.direction * (hit ? hit.t : 1.0);
    if (ray.speculars == 0) {
        frame.segment = hit.segment;
        frame.missed = !hit;
        frame.to = to;
    }
    Event& event = append(EventKind::meet);
    event.segment = hit.segment;
    event.missed = !hit;
    // Beyond a mirror or glass it starts there.
    event.onward = ray.speculars > 0;
    if (event.onward) event.from = ray.origin;
    event.to = to;
    event.direction = ray.direction;
}

void Recorder::enter(const ShadedPoint& at, std::uint32_t depth) {
    const bool parentOmitted = !open_.empty() && open_.back().call == kOmitted;
    if (parentOmitted || (depth > 0 && record_.events.size() >= limit_)) {
        record_.truncated = true;
        open_.push_back({kOmitted});
        return;
    }
    Call call;
    if (!open_.empty()) {
        call.parent = open_.back().call;
        call.sample = open_.back().n;
    }
    call.depth = depth;
    call.at = at;
    call.firstEvent = static_cast<std::uint32_t>(record_.events.size());
    open_.push_back({static_cast<std::uint32_t>(record_.calls.size())});
    record_.calls.push_back(call);
    append(EventKind::enter).segment = at.segment;
}

void Recorder::light(std::uint32_t light, std::uint32_t n, const LightSample& sample, double visible,
                     const Rgb& sum) {
    if (omitted()) return;
    Event& event = append(EventKind::light);
    event.light = light;
    event.n = n;
    event.segment = sample.segment;
    event.visible = visible > 0.0;
    event.missed = std::isinf(sample.distance);
    event.direction = sample.L;
    event.to = event.from + sample.L * (event.missed ? 1.0 : sample.distance);
    event.value = sum - open_.back().lightSum;
    event.sum = sum;
    open_.back().lightSum = sum;
}

void Recorder::sample(std::uint32_t n, double theta, double pdfAngle) {
    if (omitted()) return;
    open_.back().n = n;
    Event& event = append(EventKind::sample);
    event.theta = theta;
    event.pdfAngle = pdfAngle;
}

void Recorder::direction(std::uint32_t n, const Ray& ray) {
    if (omitted()) return;
    open_.back().n = n;
    append(EventKind::direction).direction = ray.direction;
}

void Recorder::arrival(std::uint32_t, const Ray& ray, const Radiance& sampleColor) {
    if (omitted()) return;
    const Frame& frame = open_.back();
    Event& event = append(EventKind::arrival);
    event.segment = frame.segment;
    event.missed = frame.missed;
    event.to = frame.to;
    event.direction = ray.direction;
    event.pdfAngle = ray.pdfAngle;
    event.value = sampleColor.total();
}

void Recorder::accumulate(std::uint32_t, const Rgb& added, const Rgb& sum) {
    if (omitted()) return;
    const Frame& frame = open_.back();
    Event& event = append(EventKind::accumulate);
    event.segment = frame.segment;
    event.missed = frame.missed;
    event.to = frame.to;
    event.value = added;
    event.sum = sum;
}

void Recorder::average(const Rgb& value) {
    if (omitted()) return;
    Event& event = append(EventKind::average);
    event.value = value;
    event.sum = value;
}

void Recorder::leave(const ShadedPoint&, const Irradiance& gathered) {
    if (!omitted()) {
        Event& event = append(EventKind::leave);
        event.value = gathered.total();
        event.sum = gathered.total();
        record_.calls[event.call].lastEvent = static_cast<std::uint32_t>(record_.events.size() - 1);
    }
    open_.pop_back();
}

}  // namespace halfdisk
