// Do the values of a record add up: running sums, what a call returns, the points that were met?
#include <doctest/doctest.h>

#include "core/estimate.h"
#include "core/recorder.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Settings settingsOf(std::uint32_t samples, std::uint32_t maxDepth, Emitters emitters = Emitters::hit) {
    Settings settings;
    settings.samples = samples;
    settings.maxDepth = maxDepth;
    settings.emitters = emitters;
    return settings;
}

struct Recorded {
    Record record;
    Irradiance irradiance;
    std::uint64_t rays = 0;
};

Recorded recorded(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
                  std::size_t limit = 200'000) {
    Recorder recorder(limit);
    Recorded result;
    result.irradiance =
        gatherOnce(index, at, settings, 0, SampleRange::all(settings.samples), recorder, result.rays);
    result.record = recorder.take();
    return result;
}

}  // namespace

TEST_CASE(
    "recorder: the running sums are the sums of what was added, and what a call returns is what its caller "
    "gets") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Settings settings = settingsOf(6, 2, Emitters::hit);
    const Recorded run = recorded(index, shadedPointOn(index, 0, 0.4), settings);
    const Record& record = run.record;
    const auto same = [](const Rgb& a, const Rgb& b) {
        return glm::length(a - b) <= 1e-13 * (1.0 + glm::length(b));
    };
    int scattered = 0;
    for (std::uint32_t c = 0; c < record.calls.size(); ++c) {
        Rgb sum(0.0), direct(0.0);
        double theta = 0.0, pdfAngle = 1.0;
        Rgb arrived(0.0);
        for (std::uint32_t i = record.calls[c].firstEvent; i <= record.calls[c].lastEvent; ++i) {
            const Event& event = record.events[i];
            if (event.call != c) continue;
            if (event.kind == EventKind::light) direct = event.sum;
            if (event.kind == EventKind::sample) theta = event.theta, pdfAngle = event.pdfAngle;
            if (event.kind == EventKind::arrival) {
                arrived = event.value;
                const Event& before = record.events[i - 1];
                if (before.kind == EventKind::leave) {
                    ++scattered;
                    const Call& child = record.calls[before.call];
                    REQUIRE(child.at.segment == event.segment);
                    const Rgb emitted = scene.segments[event.segment].emission;
                    REQUIRE(same(arrived, emitted + before.value * child.at.albedo / 2.0));
                }
            }
            if (event.kind == EventKind::accumulate) {
                REQUIRE(same(event.value, arrived * std::sin(theta) / pdfAngle));
                sum += event.value;
                REQUIRE(same(event.sum, sum));
            }
            if (event.kind == EventKind::average) REQUIRE(same(event.value, sum / 6.0));
            if (event.kind == EventKind::leave) REQUIRE(same(event.value, direct + sum / 6.0));
        }
    }
    CHECK(scattered > 5);
    CHECK(same(record.events.back().value, run.irradiance.total()));
}

TEST_CASE("recorder: points lie on what was met") {
    Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Record record =
        recorded(index, shadedPointOn(index, 0, 0.4), settingsOf(20, 1, Emitters::both)).record;
    int met = 0, missed = 0, lights = 0;
    for (const Event& event : record.events) {
        if (event.kind == EventKind::light && !event.missed) {
            ++lights;
            if (event.light == 0) REQUIRE(glm::length(event.to - Vec2(1.0, 1.2)) < 1e-12);
        }
        if (event.kind != EventKind::meet) continue;
        event.missed ? ++missed : ++met;
        if (event.missed) {
            REQUIRE(event.segment == kNoSegment);
            REQUIRE(glm::length(event.to - event.from - event.direction) < 1e-12);
        } else {
            const Segment& s = scene.segments[event.segment];
            REQUIRE(std::abs(glm::dot(event.to - s.a, frontNormal(s))) < 1e-12);
        }
    }
    CHECK(met > 0);
    CHECK(missed > 0);
    CHECK(lights > 0);
}
