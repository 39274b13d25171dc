#include "core/estimators/bidirectional_join.h"

#include "core/path_recorder.h"

namespace halfdisk {
namespace {

LightEnd endOf(const SegmentIndex& index, const Emission& emission, std::uint32_t environment) {
    LightEnd end{
        .light = emission.light, .segment = emission.segment, .P = emission.ray.origin, .N = emission.N};
    end.infinite =
        emission.light == environment || (isDelta(index, emission.light) && !isPoint(index, emission.light));
    end.canBeMet = emission.light == environment || emission.segment != kNoSegment;
    if (end.infinite) end.towards = -emission.ray.direction;
    return end;
}

LightEnd endOf(const SegmentIndex& index, const DrawnLight& drawn, Vec2 from, std::uint32_t environment) {
    LightEnd end{.light = drawn.light, .segment = drawn.segment};
    end.infinite = std::isinf(drawn.distance);
    end.canBeMet = drawn.light == environment || drawn.segment != kNoSegment;
    if (end.infinite) {
        end.towards = drawn.L;
        return end;
    }
    end.P = from + drawn.L * drawn.distance;
    if (drawn.segment == kNoSegment) return end;
    end.N = index.normal(drawn.segment);
    if (glm::dot(end.N, drawn.L) > 0.0) end.N = -end.N;
    return end;
}

/// All strategies of one pair of subpaths, pair after pair in the same memory.
class Join {
 public:
    Join(const JoinSetup& setup, Picture& picture, Counts& counts, StrategyPictures* apart)
        : all_(setup),
          index_(setup.problem.index),
          see_(setup.problem.record),
          apart_(apart),
          picture_(picture),
          counts_(counts) {}

    // [listing]
    // one path from each end, then every join of the two
    void run(std::uint32_t pixel, const Rng& rng) {
        const Rng sensorRng = rng.child(0), lightRng = rng.child(1);
        sensor_.clear();
        light_.clear();
        receiver_ = all_.receivers.draw(pixel, sensorRng.uniform(draws::kStart, 0),
                                        sensorRng.uniform(draws::kStart, 1));
        SubpathVisitor sensorVisitor(sensor_), lightVisitor(light_);
        Watched sensorWatched{sensorVisitor, see_};
        Watched lightWatched{lightVisitor, see_};
        if (!receiver_.covered) {
            const Sight sight = sightFrom(receiver_, index_, sensorRng.uniform(draws::kStart, 2));
            if (see_) see_->start(Carried::radiance, receiver_.at.P, Rgb(sight.weight), receiver_.at.segment);
            walk(index_, sight.ray, Rgb(sight.weight), Carried::radiance, all_.limits, sensorRng, counts_,
                 sensorWatched);
        }
        const Emission emission =
            all_.lights.emit(lightRng.uniform(draws::kStart, 0), lightRng.uniform(draws::kStart, 1));
        if (emission.power != Rgb(0.0)) {
            lightEnd_ = endOf(index_, emission, all_.lights.environmentLight());
            if (see_) see_->start(Carried::power, emission.ray.origin, emission.power, emission.segment);
            walk(index_, emission.ray, emission.power, Carried::power, all_.limits, lightRng, counts_,
                 lightWatched);
        }
        joinAll(lightRng);
    }
    // [end]

 private:
    // [listing]
    void joinAll(const Rng& rng) {
        const std::size_t lightVertices = light_.vertices.size() + 1,
                          sensorVertices = sensor_.vertices.size() + 1;
        for (std::size_t t = 1; t <= sensorVertices; ++t) {
            if (t > 1 && all_.asks(0, t)) meetLamp(t);
            if (all_.asks(1, t)) askLight(t, rng);
            for (std::size_t s = 2; s <= lightVertices; ++s) {
                if (!all_.asks(s, t)) continue;
                if (t == 1) {
                    connectToSensor(s);
                } else {
                    connectWalls(s, t);
                }
            }
        }
        if (all_.asks(0, sensorVertices + 1)) meetEnvironment(sensorVertices + 1);
        for (std::size_t s = 2; all_.bins && s <= lightVertices; ++s)
            if (all_.asks(s, 0)) meetSensor(s);
    }
    // [end]

    /// The first `fromLight` walls of the light's path and the first `fromSensor` of the sensor's, from the
    /// light on. Where the two are connected, their ends scatter whatever they did on their own.
    /// Good until the next call.
    std::span<const InnerVertex> walls(std::size_t fromLight, std::size_t fromSensor, bool connected) {
        walls_.clear();
        for (std::size_t i = 0; i < fromLight; ++i) walls_.push_back(light_.vertices[i].wall);
        if (connected && fromLight > 0) walls_.back().delta = false;
        for (std::size_t i = fromSensor; i-- > 0;) {
            walls_.push_back(sensor_.vertices[i].wall);
            if (connected && i + 1 == fromSensor) walls_.back().delta = false;
        }
        return walls_;
    }

    // Strategy (s, t), joined by a straight line from the light's part to the sensor's.
    struct Joint {
        std::size_t s, t;
        Vec2 from, to;
        SourceLine where;
    };
    static Joint jointAt(std::size_t s, std::size_t t, Vec2 from, Vec2 to,
                         SourceLine where = SourceLine::here()) {
        return {s, t, from, to, where};
    }

    // [listing]
    // a whole path: its value, times this strategy's share among all that could have made it
    void add(const Receiver& at, const Joint& joint, const LightEnd& end, std::span<const InnerVertex> inner,
             double pdfReceiver, const Rgb& value) {
        if (see_ && !see_->wants(at.pixel)) return;
        std::uint32_t scatterings = 0;
        for (const InnerVertex& wall : inner) scatterings += wall.delta ? 0 : 1;
        if (value == Rgb(0.0) || scatterings > all_.limits.scatterings) return;
        double weight = 1.0;
        if (all_.weighs)
            weight = WholePath(all_.lights, end, inner, at, pdfReceiver)
                         .weight(joint.s, all_.counts, all_.heuristic);
        addTo(picture_, at.pixel, value * weight, counts_);
        tell(joint, at.pixel, weight, value);
    }
    // [end]

    void tell(const Joint& joint, std::uint32_t pixel, double weight, const Rgb& value) {
        if (!see_ && !apart_) return;
        const auto s = static_cast<std::uint32_t>(joint.s), t = static_cast<std::uint32_t>(joint.t);
        if (apart_) apart_->add({s, t}, pixel, value, weight);
        if (see_) see_->joined(joint.from, joint.to, s, t, weight > 0.0, weight, value * weight, joint.where);
    }
    void tellBlocked(const Joint& joint) { tell(joint, 0, 0.0, Rgb(0.0)); }
    static Vec2 placeOf(const DrawnLight& drawn, Vec2 seenFrom) {
        return seenFrom + drawn.L * (std::isinf(drawn.distance) ? 1.0 : drawn.distance);
    }

    double pdfReceiver() const { return all_.bins ? 1.0 / all_.bins->binLength() : 1.0; }

    // [listing]
    // s = 0: the sensor's path meets a lamp at its vertex t - 1.
    void meetLamp(std::size_t t) {
        const Subpath::Vertex& met = sensor_.vertices[t - 2];
        const SurfacePoint& at = met.wall.at;
        const Segment& wall = index_.scene().segments[at.segment];
        if (!isEmitter(wall) || !(at.front || wall.twoSided)) return;
        const LightEnd end{.light = all_.lights.lightOf(at.segment),
                           .segment = at.segment,
                           .canBeMet = true,
                           .P = at.P,
                           .N = at.N};
        const Joint joint = jointAt(0, t, at.P, at.P);
        add(receiver_, joint, end, walls(0, t - 2, false), pdfReceiver(), met.throughput * wall.emission);
    }

    void meetEnvironment(std::size_t t) {
        if (sensor_.escapedThroughput == Rgb(0.0)) return;
        const LightEnd end{.light = all_.lights.environmentLight(),
                           .infinite = true,
                           .canBeMet = true,
                           .towards = sensor_.escaped.direction};
        const Vec2 out = sensor_.escaped.origin;
        const Joint joint = jointAt(0, t, out + end.towards, out);
        add(receiver_, joint, end, walls(0, t - 2, false), pdfReceiver(),
            sensor_.escapedThroughput * index_.environment(end.towards));
    }

    // s = 1: a light is asked at the sensor's vertex t - 1.
    void askLight(std::size_t t, const Rng& rng) {
        const auto sample = static_cast<std::uint32_t>(t);
        const double pick = rng.uniform(sample, draws::kPick), u = rng.uniform(sample, draws::kLight);
        const std::uint32_t environment = all_.lights.environmentLight();
        if (t == 1) {
            const DrawnLight drawn = drawLight(all_.lights, receiver_, pick, u, counts_);
            const Joint joint = jointAt(1, 1, placeOf(drawn, receiver_.at.P), receiver_.at.P);
            if (drawn.L_i == Rgb(0.0)) return tellBlocked(joint);
            // An eye does not see a light that has no size.
            if (drawn.pdfAngle == 0.0 && !gathers(receiver_)) return;
            addConnected(joint, endOf(index_, drawn, receiver_.at.P, environment), {},
                         responseTo(receiver_, drawn.L), drawn.L_i);
            return;
        }
        const Subpath::Vertex& asking = sensor_.vertices[t - 2];
        const SurfacePoint& at = asking.wall.at;
        if (isSpecular(*at.material)) return;
        const DrawnLight drawn = drawLight(all_.lights, at, pick, u, counts_);
        const Joint joint = jointAt(1, t, placeOf(drawn, at.P), at.P);
        if (drawn.L_i == Rgb(0.0)) return tellBlocked(joint);
        add(receiver_, joint, endOf(index_, drawn, at.P, environment), walls(0, t - 1, true), pdfReceiver(),
            asking.throughput * evalSurface(at, drawn.L, at.from) * drawn.L_i * glm::dot(at.N, drawn.L));
    }

    // t = 1: the light's vertex s - 1 is connected to the sensor's own place.
    void connectToSensor(std::size_t s) {
        const Subpath::Vertex& last = light_.vertices[s - 2];
        const SurfacePoint& at = last.wall.at;
        if (isSpecular(*at.material)) return;
        const Connection way = connect(index_, at, receiver_, counts_);
        const Joint joint = jointAt(s, 1, at.P, receiver_.at.P);
        if (way.passed == Rgb(0.0)) return tellBlocked(joint);
        addConnected(joint, lightEnd_, walls(s - 1, 0, true), way.response,
                     last.throughput * evalSurface(at, at.from, way.toReceiver) * way.passed *
                         (glm::dot(at.N, way.toReceiver) / way.distance));
    }

    /// Radiance that one of the light's paths brings straight to the sensor's place; every pixel's path may
    /// serve any pixel of an eye.
    void addConnected(const Joint& joint, const LightEnd& end, std::span<const InnerVertex> inner,
                      const Response& response, const Rgb& radiance) {
        Receiver at = receiver_;
        at.pixel = response.pixel;
        add(at, joint, end, inner, pdfReceiver(), radiance * (response.weight / all_.counts.lightConnected));
    }

    void connectWalls(std::size_t s, std::size_t t) {
        const Subpath::Vertex& y = light_.vertices[s - 2];
        const Subpath::Vertex& z = sensor_.vertices[t - 2];
        const SurfacePoint &a = y.wall.at, &b = z.wall.at;
        if (isSpecular(*a.material) || isSpecular(*b.material) || a.segment == b.segment) return;
        if (y.scatterings + z.scatterings + 2 > all_.limits.scatterings) return;
        const Vec2 gap = b.P - a.P;
        const double r = glm::length(gap);
        if (r == 0.0) return;
        const Vec2 way = gap / r;
        const double cosines = std::max(0.0, glm::dot(a.N, way)) * std::max(0.0, -glm::dot(b.N, way));
        if (cosines == 0.0) return;
        const Rgb value = y.throughput * evalSurface(a, a.from, way) * evalSurface(b, -way, b.from) *
                          z.throughput * (cosines / r);
        if (value == Rgb(0.0)) return;
        ++counts_.rays;
        const Joint joint = jointAt(s, t, a.P, b.P);
        if (index_.occluded({originOff(index_, a.segment, a.P, way), way, a.segment}, r, b.segment))
            return tellBlocked(joint);
        add(receiver_, joint, lightEnd_, walls(s - 1, t - 1, true), pdfReceiver(),
            value * transmittance(index_, a.medium, r));
    }

    // t = 0: the light's path meets the profile at its vertex s - 1.
    void meetSensor(std::size_t s) {
        const Subpath::Vertex& met = light_.vertices[s - 2];
        const SurfacePoint& at = met.wall.at;
        const auto place = at.front ? all_.bins->at(at.segment, met.u) : std::nullopt;
        if (!place) return;
        const Receiver receiver{.at = {at.P, at.N, at.segment}, .pixel = place->bin};
        const Joint joint = jointAt(s, 0, at.P, at.P);
        add(receiver, joint, lightEnd_, walls(s - 2, 0, false), 1.0 / place->length,
            met.throughput / (place->length * all_.counts.lightAlone));
    }

    // [end]

    const JoinSetup& all_;
    const SegmentIndex& index_;
    PathRecorder* see_;        // may be null
    StrategyPictures* apart_;  // may be null
    Picture& picture_;
    Counts& counts_;
    Receiver receiver_;
    Subpath sensor_, light_;
    std::vector<InnerVertex> walls_;
    LightEnd lightEnd_;
};

}  // namespace

void joinPaths(const JoinSetup& setup, std::uint64_t pass, Picture& picture, Counts& counts,
               StrategyPictures* apart) {
    Join join(setup, picture, counts, apart);
    for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
        throwIfStopped(setup.problem.stop, pixel);
        if (setup.problem.record && !setup.problem.record->wants(pixel)) continue;
        join.run(pixel, Rng(setup.problem.seed, pass).child(pixel));
        counts.paths += 2;
    }
}

}  // namespace halfdisk
