// Is the record of a run a consistent tree that can be read forwards and backwards, and does recording change
// nothing?
#include <doctest/doctest.h>

#include <map>

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

TEST_CASE("recorder: a recorded run returns the same bits and casts the same rays") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    for (const auto& emitters : kEmitters)
        for (const DefectSet defects : {DefectSet{}, DefectSet::all()}) {
            Settings settings = settingsOf(7, 2, emitters.value);
            settings.defects = defects;
            const ShadedPoint at = shadedPointOn(index, 0, 0.4);
            const Recorded seen = recorded(index, at, settings);
            NoObserver observer;
            std::uint64_t rays = 0;
            const Irradiance E = gatherOnce(index, at, settings, 0, SampleRange::all(7), observer, rays);
            CHECK(seen.irradiance.direct == E.direct);
            CHECK(seen.irradiance.indirect == E.indirect);
            CHECK(seen.rays == rays);
            CHECK(seen.record.rays == rays);
        }
}

TEST_CASE("recorder: N^d half-disks at depth d, each below the sample that led to it") {
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex index(room);
    const Record record = recorded(index, shadedPointOn(index, 0, 0.5), settingsOf(5, 3)).record;
    CHECK_FALSE(record.truncated);
    CHECK(record.rays == 5 + 25 + 125 + 625);
    std::map<std::uint32_t, int> perDepth;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> children;
    for (std::uint32_t c = 0; c < record.calls.size(); ++c) {
        const Call& call = record.calls[c];
        ++perDepth[call.depth];
        if (c == 0) {
            CHECK(call.parent == kNoCall);
            continue;
        }
        REQUIRE(call.parent < c);
        REQUIRE(record.calls[call.parent].depth + 1 == call.depth);
        ++children[{call.parent, call.sample}];
    }
    CHECK(perDepth == std::map<std::uint32_t, int>{{0, 1}, {1, 5}, {2, 25}, {3, 125}});
    CHECK(children.size() == 155);
    for (const auto& [sample, count] : children) REQUIRE(count == 1);
}

TEST_CASE("recorder: calls are brackets of events, one inside the other") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Record record =
        recorded(index, shadedPointOn(index, 0, 0.4), settingsOf(6, 2, Emitters::both)).record;
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < record.events.size(); ++i) {
        const Event& event = record.events[i];
        const Call& call = record.calls[event.call];
        if (event.kind == EventKind::enter) {
            REQUIRE(call.firstEvent == i);
            REQUIRE(call.parent == (open.empty() ? kNoCall : open.back()));
            open.push_back(event.call);
        }
        REQUIRE_FALSE(open.empty());
        REQUIRE(open.back() == event.call);
        REQUIRE(event.depth == call.depth);
        REQUIRE(event.depth + 1 == open.size());
        REQUIRE(event.from == call.at.P);
        if (event.kind == EventKind::leave) {
            REQUIRE(call.lastEvent == i);
            open.pop_back();
        }
    }
    CHECK(open.empty());
    CHECK(record.events.front().kind == EventKind::enter);
    CHECK(record.events.back().kind == EventKind::leave);
}

TEST_CASE("recorder: every sample passes through the listing's steps in their order") {
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex index(room);
    const Record record = recorded(index, shadedPointOn(index, 0, 0.5), settingsOf(4, 1)).record;
    for (std::uint32_t c = 0; c < record.calls.size(); ++c) {
        std::vector<EventKind> kinds;
        std::uint32_t sample = 0;
        for (const Event& event : record.events) {
            if (event.call != c) continue;
            kinds.push_back(event.kind);
            if (event.kind == EventKind::sample) REQUIRE(event.n == sample++);
            if (event.kind == EventKind::accumulate) REQUIRE(event.n + 1 == sample);
        }
        std::vector<EventKind> expected = {EventKind::enter};
        for (int n = 0; n < 4; ++n)
            for (const EventKind kind : {EventKind::sample, EventKind::direction, EventKind::meet,
                                         EventKind::arrival, EventKind::accumulate})
                expected.push_back(kind);
        expected.push_back(EventKind::average);
        expected.push_back(EventKind::leave);
        REQUIRE(kinds == expected);
    }
}

TEST_CASE("recorder: a full record keeps all of depth 0 and says that it was cut") {
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex index(room);
    const ShadedPoint at = shadedPointOn(index, 0, 0.5);
    const auto depth0 = [](const Record& record) {
        int count = 0;
        for (const Event& event : record.events) count += event.depth == 0;
        return count;
    };
    const Recorded whole = recorded(index, at, settingsOf(10, 2)),
                   cut = recorded(index, at, settingsOf(10, 2), 60);
    CHECK_FALSE(whole.record.truncated);
    CHECK(cut.record.truncated);
    CHECK(depth0(cut.record) == depth0(whole.record));
    CHECK(cut.record.events.size() < 60 + 10 * 5 + 60);
    CHECK(cut.irradiance.indirect == whole.irradiance.indirect);
    CHECK(cut.rays == whole.rays);
    CHECK(cut.record.rays == whole.record.rays);
    CHECK(recorded(index, at, settingsOf(10, 2), 0).record.calls.size() == 1);
}

TEST_CASE("recorder: stops when it is cancelled") {
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex index(room);
    const std::atomic<bool> cancelled = true;
    Recorder recorder(1000, &cancelled);
    std::uint64_t rays = 0;
    gatherOnce(index, shadedPointOn(index, 0, 0.5), settingsOf(1'000'000'000, 4), 0,
               SampleRange::all(1'000'000'000), recorder, rays);
    CHECK(rays == 0);
}

TEST_CASE("recorder: steps and their lines in the published listing") {
    CHECK(listingLine(EventKind::enter) == 3);
    CHECK(listingLine(EventKind::light) == 10);
    CHECK(listingLine(EventKind::sample) == 17);
    CHECK(listingLine(EventKind::direction) == 21);
    CHECK(listingLine(EventKind::meet) == 24);
    CHECK(listingLine(EventKind::arrival) == 24);
    CHECK(listingLine(EventKind::accumulate) == 27);
    CHECK(listingLine(EventKind::average) == 30);
    CHECK(listingLine(EventKind::leave) == 33);
}
