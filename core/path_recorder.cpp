#include "path_recorder.h"

namespace halfdisk {

PathEvent* PathRecorder::append(PathEventKind kind, SourceLine where) {
    if (full_) return nullptr;
    PathEvent& event = record_.events.emplace_back(now_);
    event.kind = kind;
    event.sum = sum_;
    event.where = where;
    return &event;
}

void PathRecorder::add(PathEvent* event, const Rgb& value) {
    const Rgb counted = share_ * value;
    sum_ += counted;
    if (!event) return;
    event->value = counted;
    event->sum = sum_;
}

void PathRecorder::start(Carried carried, Vec2 at, const Rgb& throughput, std::uint32_t segment,
                         SourceLine where) {
    now_ = {};
    now_.carried = carried;
    now_.path = record_.paths++;
    now_.from = now_.to = at;
    now_.throughput = throughput;
    // A path is kept whole or not at all.
    if (record_.events.size() >= limit_) full_ = record_.truncated = true;
    if (PathEvent* event = append(PathEventKind::start, where)) event->segment = segment;
}

void PathRecorder::fly(const Ray& ray, double distance, const Rgb& throughput, SourceLine where) {
    now_.missed = distance == kInfinity;
    now_.from = ray.origin;
    now_.to = ray.origin + (now_.missed ? 1.0 : distance) * ray.direction;
    now_.throughput = throughput;
    if (PathEvent* event = append(PathEventKind::fly, where)) event->pdfAngle = ray.pdfAngle;
    now_.missed = false;
}

void PathRecorder::arrive(const Arrival& here, SourceLine where) {
    now_.vertex = here.vertex + 1;
    now_.from = now_.to = here.at.P;
    now_.throughput = here.throughput;
    if (PathEvent* event = append(PathEventKind::arrive, where)) event->segment = here.at.segment;
}

void PathRecorder::escape(const Ray& ray, const Rgb& throughput, SourceLine where) {
    now_.from = ray.origin;
    now_.to = ray.origin + ray.direction;
    now_.throughput = throughput;
    if (PathEvent* event = append(PathEventKind::escape, where)) event->missed = true;
}

void PathRecorder::depart(const Arrival& here, const Scattered& way, SourceLine where) {
    now_.from = here.at.P;
    now_.to = here.at.P + way.direction;
    PathEvent* event = append(PathEventKind::depart, where);
    if (!event) return;
    event->segment = here.at.segment;
    event->delta = way.isDelta();
    event->pdfAngle = way.isDelta() ? 0.0 : way.pdfAngle;
    event->throughput = way.weight;
}

void PathRecorder::end(Ending why, SourceLine where) {
    if (PathEvent* event = append(PathEventKind::end, where)) event->ending = why;
}

void PathRecorder::met(const Ray& ray, const Hit& hit, double share, const Rgb& value, SourceLine where) {
    PathEvent* event = append(PathEventKind::met, where);
    if (event) {
        event->from = ray.origin;
        event->to = ray.origin + (hit ? hit.t : 1.0) * ray.direction;
        event->segment = hit.segment;
        event->missed = !hit;
        event->weight = share;
    }
    add(event, value);
}

void PathRecorder::asked(Vec2 from, const AskedLight& light, const Rgb& value, SourceLine where) {
    PathEvent* event = append(PathEventKind::asked, where);
    if (event) {
        event->from = from;
        event->missed = std::isinf(light.light.distance);
        event->to = from + light.light.L * (event->missed ? 1.0 : light.light.distance);
        event->segment = light.light.segment;
        event->visible = light.light.L_i != Rgb(0.0);
        event->weight = light.share;
    }
    add(event, value);
}

void PathRecorder::joined(Vec2 from, Vec2 to, std::uint32_t s, std::uint32_t t, bool visible, double share,
                          const Rgb& value, SourceLine where) {
    PathEvent* event = append(PathEventKind::joined, where);
    if (event) {
        event->from = from;
        event->to = to;
        event->vertex = 0;
        event->s = s;
        event->t = t;
        event->visible = visible;
        event->weight = share;
    }
    add(event, value);
}

void PathRecorder::kept(Vec2 at, std::uint32_t segment, const Rgb& power, SourceLine where) {
    PathEvent* event = append(PathEventKind::kept, where);
    if (!event) return;
    event->from = event->to = at;
    event->segment = segment;
    event->throughput = power;
}

void PathRecorder::lookedUp(Vec2 at, std::uint32_t segment, double radius, std::uint32_t photons,
                            const Rgb& value, SourceLine where) {
    PathEvent* event = append(PathEventKind::lookedUp, where);
    if (event) {
        event->from = event->to = at;
        event->segment = segment;
        event->radius = radius;
        event->photons = photons;
    }
    add(event, value);
}

}  // namespace halfdisk
