// Does the table of extremes tell the truth: does it hold, can it fail, and does the naive twin break where
// it is said to?
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "core/estimate.h"
#include "core/exact.h"
#include "core/extremes/cell.h"
#include "core/extremes/dial.h"
#include "core/extremes/float_fit.h"
#include "core/extremes/furnace.h"
#include "core/extremes/sums.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Scene someRoom() {
    return furnaceOf(halfdisk::furnacePolygon(), FurnaceQuestion{}.albedo);
}

const ExtremeCell& cellOf(const std::vector<ExtremeCell>& cells, const std::string& id) {
    for (const ExtremeCell& cell : cells)
        if (cell.id == id) return cell;
    FAIL("no cell " << id);
    return cells.front();
}

}  // namespace

TEST_CASE("extremes table: ids are unique, and every bound has its reason") {
    std::set<std::string> ids;
    for (const ExtremeCell& cell : extremeCells()) {
        INFO(cell.id);
        CHECK(ids.insert(cell.id).second);
        CHECK_FALSE(cell.title.empty());
        CHECK_FALSE(cell.unit.empty());
        CHECK_FALSE(cell.why.empty());
        CHECK(cell.bound >= 0.0);
        CHECK(cell.bound < 1e-6);  // a bound that says nothing is none
    }
    CHECK(ids.size() >= 55);
}

TEST_CASE("extremes table: a cell fails by its error, by a lost ray, by NaN and by a fault") {
    ExtremeCell cell;
    cell.bound = 1e-12;
    ExtremeOutcome good;
    good.ours.error = 1e-12;
    CHECK(holds(cell, good));
    ExtremeOutcome bad = good;
    bad.ours.error = 1.01e-12;
    CHECK_FALSE(holds(cell, bad));
    bad.ours.error = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(holds(cell, bad));
    for (const auto count : {&ExtremeCounts::leaks, &ExtremeCounts::selfHits, &ExtremeCounts::nonFinite}) {
        bad = good;
        bad.ours.counts.*count = 1;
        CHECK_FALSE(holds(cell, bad));
    }
    bad = good;
    bad.fault = "wrong";
    CHECK_FALSE(holds(cell, bad));
}

TEST_CASE("extremes table: the naive twin breaks where it is said to") {
    const auto cells = extremeCells();
    for (const char* id :
         {"scale:1e-6", "scale:1e6", "offset:1e5", "length:1e-7", "angle:1e-6", "gap:1e-5", "corner:1e-3",
          "lamp-plane:1e-7", "critical:+1e-6", "radiance:1e30", "coincident"}) {
        INFO(id);
        const ExtremeCell& cell = cellOf(cells, id);
        CHECK_FALSE(holds(cell, cell.run({}).naiveFloat));
    }
}

TEST_CASE("survey: an origin on the wall, in double, meets its own wall; the product's never does") {
    const Scene room = someRoom();
    const ExtremeCounts none = surveyNaive(room, {}, {}, Precision::twice, EpsilonPolicy::none);
    CHECK(none.selfHits > 100);
    const ExtremeCounts ours = surveyOurs(room, {}, {});
    CHECK(ours.rays == 20'000);
    CHECK(ours.faults() == 0);
    CHECK(ours.place < 1e-9);
    CHECK(ours.early == 0);
    CHECK(ours.light == 0.0);
    // The same method, written out in double by the twin.
    CHECK(surveyNaive(room, {}, {}, Precision::twice, EpsilonPolicy::ours).faults() == 0);
}

TEST_CASE("survey: a fixed step leaks through a gap that is smaller, and only there") {
    for (const double gap : {1e-1, 1e-5}) {
        const Scene room = furnaceOf({{0.0, 0.0}, {1.0, 0.0}, {1.0, gap}, {0.0, gap}}, 0.5);
        SurveyRays rays;
        rays.ends = false;  // next to a corner it leaks at any gap
        const ExtremeCounts naive = surveyNaive(room, {}, rays, Precision::twice, EpsilonPolicy::fixed, 1e-4);
        CAPTURE(gap);
        if (gap > 1e-4) {
            CHECK(naive.leaks < naive.rays / 100);
        } else {
            CHECK(naive.leaks > naive.rays / 2);
        }
    }
}

TEST_CASE("survey: a wall that float gives no length is not finite") {
    Scene room = furnaceOf({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1e-9}, {1.0, 1.0}, {0.0, 1.0}}, 0.5);
    const ExtremeCounts naive = surveyNaive(room, {1.0, 1e5}, {}, Precision::single, EpsilonPolicy::fixed);
    CHECK(naive.nonFinite > naive.rays / 10);  // a fifth of the rays start there
    const FloatFit fit = floatFitOf(placed(room, {1.0, 1e5}));
    CHECK(fit.lost >= 1);
    CHECK_FALSE(fit.holds());
    CHECK(floatFitOf(someRoom()).holds());
}

TEST_CASE("survey: far from the origin rays from a round thing's corners are judged as they are") {
    // At 1e6 m a coordinate of the truth itself would be rounded by more than the start is away from a
    // corner.
    for (const double away : {1e6, 3e7}) {
        Scene scene;
        const Vec2 corner(away, -away), middle = corner + Vec2(1.0);
        const Vec2 corners[] = {corner, corner + Vec2(2.0, 0.0), corner + Vec2(2.0), corner + Vec2(0.0, 2.0)};
        for (int i = 0; i < 4; ++i) addWall(scene, corners[i], corners[(i + 1) % 4]);
        constexpr int kFacets = 64;
        const auto onBall = [&](int i) {
            const double angle = -2.0 * kPi * (i % kFacets) / kFacets;
            return middle + 0.4 * Vec2(std::cos(angle), std::sin(angle));
        };
        for (int i = 0; i < kFacets; ++i) addWall(scene, onBall(i), onBall(i + 1));
        INFO(away);
        const ExtremeCounts ours = surveyOurs(scene, {}, {.count = 100'000});
        CHECK(ours.faults() == 0);
        const ExtremeCounts naive = surveyNaive(scene, {}, {}, Precision::twice, EpsilonPolicy::fixed, 1e-4);
        CHECK(naive.faults() > 0);
    }
}

TEST_CASE("placed: light stays as it was, wherever the scene is put") {
    Scene scene = litBox();
    for (const Placement& placing : {Placement{1e-3, 0.0}, Placement{1e3, 10.0}, Placement{1.0, 1e3}}) {
        const Scene there = placed(scene, placing);
        CHECK(sizeOf(there) == doctest::Approx(placing.scale * sizeOf(scene)).epsilon(1e-9));
        const SegmentIndex home(scene), away(there);
        const Visibility fromHome(home), fromAway(away);
        for (std::uint32_t wall = 0; wall < 4; ++wall)
            CHECK(
                directIrradiance(fromAway, shadedPointOn(away, wall, 0.4)).x ==
                doctest::Approx(directIrradiance(fromHome, shadedPointOn(home, wall, 0.4)).x).epsilon(1e-9));
    }
}

TEST_CASE("furnace: one path of many that is lost is seen") {
    Scene room = someRoom();
    CHECK(furnaceError(room, {}) <= furnaceBound(5));
    room.segments[2].emission = Rgb(1.0 - 1e-9);  // what a lost ray in a thousand million would do
    CHECK(furnaceError(room, {}) > furnaceBound(5));
    room.segments.pop_back();
    CHECK(furnaceError(room, {}) > 0.01);
}

TEST_CASE("dial: the product loses no ray; float and a fixed step do") {
    for (const Scene& scene : {someRoom(), litBox(), mixedRoom()})
        for (const double gap : {0.0, 1e-6})
            for (const double offset : {0.0, 1e4}) {
                DialSetting setting;
                setting.gap = gap;
                setting.offset = offset;
                const ExtremeCounts ours = measureDial(setting, scene);
                CHECK(ours.rays == setting.rays);
                CHECK(ours.faults() == 0);
                CHECK(ours.early <= 4);
                CHECK(ours.place < 1e-8 * (1.0 + offset));
                setting.policy = EpsilonPolicy::fixed;
                setting.precision = Precision::single;
                CHECK(measureDial(setting, scene).faults() > (gap > 0.0 || offset > 0.0 ? 100 : 0));
            }
    CHECK(measureDial({}, Scene{}).rays == 0);
    DialSetting slit;
    slit.gap = 0.1;
    CHECK(measureDial(slit, Scene{}).rays > 0);
    CHECK_THROWS_AS(measureDial({}, someRoom(), [] { return true; }), Stopped);
}

TEST_CASE("survey: rays that go wrong are kept where they start and where they should end") {
    const Scene room = someRoom();  // closed: each ray has a wall to meet
    const Vec2 middle = boxOf(room).middle();
    SurveyRays rays;
    rays.kept = 7;
    for (const double offset : {0.0, 1e5}) {
        const ExtremeCounts counts =
            surveyNaive(room, {1.0, offset}, rays, Precision::single, EpsilonPolicy::none);
        const auto kept = [&](LostRay::How how) {
            return std::count_if(counts.lost.begin(), counts.lost.end(),
                                 [&](const LostRay& ray) { return ray.how == how; });
        };
        CAPTURE(offset);
        REQUIRE(counts.selfHits > rays.kept);
        CHECK(kept(LostRay::How::selfHit) == 7);
        CHECK(kept(LostRay::How::leak) ==
              static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(7, counts.leaks)));
        CHECK(counts.lost.size() <= 21);
        for (const LostRay& ray : counts.lost)
            for (const Vec2 end : {ray.from, ray.to}) {
                double nearest = 1.0;
                for (const Segment& wall : room.segments) {
                    const Vec2 along = glm::normalize(wall.b - wall.a), to = end - wall.a;
                    const double t = std::clamp(glm::dot(to, along), 0.0, glm::length(wall.b - wall.a));
                    nearest = std::min(nearest, glm::length(to - t * along));
                }
                CHECK(nearest < 1e-12);
                CHECK(glm::length(end - middle) <= sizeOf(room));
            }
    }
    CHECK(surveyOurs(room, {1.0, 1e5}, rays).lost.empty());
    rays.kept = 0;
    CHECK(surveyNaive(room, {}, rays, Precision::single, EpsilonPolicy::none).lost.empty());
}

TEST_CASE("dial: the same setting gives the same counts, and many walls fewer rays") {
    DialSetting setting;
    setting.policy = EpsilonPolicy::relative;
    setting.precision = Precision::single;
    const ExtremeCounts a = measureDial(setting, someRoom()), b = measureDial(setting, someRoom());
    CHECK(a.leaks == b.leaks);
    CHECK(a.selfHits == b.selfHits);
    CHECK(measureDial(setting, polygonRoom(regularPolygon(2000))).rays <= 101);
}

TEST_CASE("sums: Welford and compensated sums are right where plain ones are not") {
    NaiveSums<float> naive;
    WelfordSums<float> welford;
    CompensatedSum<float> compensated;
    constexpr int kCount = 1'000'000;
    for (int i = 0; i < kCount; ++i) {
        const float x = 1000.0f + (i % 2 == 0 ? 0.25f : -0.25f);
        naive.add(x);
        welford.add(x, static_cast<float>(i + 1));
        compensated.add(x);
    }
    CHECK(std::abs(naive.mean(kCount) - 1000.0f) > 0.1f);
    CHECK(std::abs(naive.variance(kCount) - 0.0625f) > 1.0f);
    CHECK(compensated.sum == 1e9f);
    CHECK(welford.average == doctest::Approx(1000.0).epsilon(1e-3));
}

TEST_CASE("exact: a lamp's irradiance keeps its digits however small it is and however flat it lies") {
    // 1 m above P and `size` wide; and on the horizon, `size` high at 1 m.
    for (const double size : {1.0, 1e-3, 1e-6, 1e-9}) {
        CAPTURE(size);
        Segment above, beside;
        above.a = {0.5 + size, 1.0}, above.b = {0.5, 1.0};
        above.emission = beside.emission = Rgb(1.0);
        beside.a = {1.0, 0.0}, beside.b = {1.0, size};
        const long double w = static_cast<long double>(0.5 + size), s = static_cast<long double>(size);
        // sqrt and a difference of 64-bit mantissas: good to 1e-19 / size.
        const double exactAbove = static_cast<double>(w / std::sqrt(w * w + 1) - 0.5L / std::sqrt(0.25L + 1));
        const double exactBeside = static_cast<double>(-std::expm1(-0.5L * std::log1p(s * s)));
        CHECK(segmentIrradiance({0.0, 0.0}, {0.0, 1.0}, above).x ==
              doctest::Approx(exactAbove).epsilon(1e-15 + 2e-18 / size));
        CHECK(segmentIrradiance({0.0, 0.0}, {0.0, 1.0}, beside).x ==
              doctest::Approx(exactBeside).epsilon(1e-14));
    }
}
