// Rows of walls that meet: on each other, across each other, and a million of them around a circle.
#include <algorithm>

#include "core/estimate.h"
#include "core/extremes/furnace.h"
#include "core/extremes/rows.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kRays = 20'000;

/// A wall cuts a room in two: to the left it is wall 4, to the right wall 5. Wall 6 lies on the middle of
/// wall 4, up to rounding. Askew, so that rounding there is.
Scene roomsBackToBack() {
    const Vec2 from(0.31, 0.07), along = Vec2(0.3, 0.9);
    const auto at = [&](double u) { return from + u * along; };
    Scene scene = furnaceOf({{-1.0, -1.0}, {2.0, -1.0}, {2.0, 2.0}, {-1.0, 2.0}}, 0.5);
    const auto add = [&](Vec2 a, Vec2 b) {
        scene.segments.push_back(scene.segments.front());
        scene.segments.back().a = a;
        scene.segments.back().b = b;
        scene.segmentNames.emplace_back("between");
    };
    add(at(0.0), at(1.0));
    add(at(1.0), at(0.0));
    add(at(0.25), at(0.75));
    return scene;
}

/// Share of rays at the wall in between that meet another than the one that faces them and comes first.
template <class Ask>
double wrongShare(const Scene& scene, const Ask& ask) {
    const Rng rng(3, 0);
    std::uint32_t wrong = 0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        const Segment& wall = scene.segments[4];
        const Vec2 aim = wall.a + (0.01 + 0.98 * rng.uniform(i, 0)) * (wall.b - wall.a);
        const double angle = kPi * (0.01 + 0.98 * rng.uniform(i, 1));
        const bool left = i % 2 == 0;
        const Vec2 N = left ? frontNormal(wall) : -frontNormal(wall);
        const Vec2 way = 0.5 * frameFromNormal(N).toWorld(std::cos(angle), std::sin(angle));
        if (ask(aim + way, -way) != (left ? 4u : 5u)) ++wrong;
    }
    return static_cast<double>(wrong) / kRays;
}

template <class Real>
double naiveWrongShare(const Scene& scene) {
    const NaiveRoom<Real> room(scene);
    return wrongShare(scene, [&](Vec2 origin, Vec2 direction) {
        return room
            .closestHit({{static_cast<Real>(origin.x), static_cast<Real>(origin.y)},
                         {static_cast<Real>(direction.x), static_cast<Real>(direction.y)}})
            .segment;
    });
}

ExtremeOutcome coincident(const StopQuestion&) {
    const Scene scene = roomsBackToBack();
    const SegmentIndex index(scene);
    ExtremeOutcome outcome;
    outcome.ours.error = wrongShare(scene, [&](Vec2 origin, Vec2 direction) {
        return index.closestHit({origin, direction}).segment;
    });
    outcome.naiveFloat.error = naiveWrongShare<float>(scene);
    outcome.naiveDouble.error = naiveWrongShare<double>(scene);
    return outcome;
}

/// Four walls that reach beyond each other's crossings, like #.
Scene crossingRoom() {
    const Vec2 ends[4][2] = {{{-1.0, 0.13}, {2.0, -0.17}},
                             {{0.9, -1.0}, {1.1, 2.0}},
                             {{2.0, 1.06}, {-1.0, 0.93}},
                             {{0.11, 2.0}, {-0.07, -1.0}}};
    Scene scene = furnaceOf(std::vector<Vec2>(4), 0.5);
    for (std::size_t i = 0; i < 4; ++i) {
        scene.segments[i].a = ends[i][0];
        scene.segments[i].b = ends[i][1];
    }
    return scene;
}

ExtremeOutcome crossing(const StopQuestion& stop) {
    const Scene scene = crossingRoom();
    ExtremeOutcome outcome;
    outcome.ours.counts = surveyOurs(scene, {}, {}, stop);
    outcome.naiveFloat.counts =
        surveyNaive(scene, {}, {}, Precision::single, EpsilonPolicy::fixed, 1e-4, stop);
    outcome.naiveDouble.counts =
        surveyNaive(scene, {}, {}, Precision::twice, EpsilonPolicy::fixed, 1e-4, stop);
    for (ExtremeSide* side : {&outcome.ours, &outcome.naiveFloat, &outcome.naiveDouble})
        side->error = side->counts.lostShare();
    return outcome;
}

/// An angle over the half-disk, every fourth nearly along the wall.
double someAngle(const Rng& rng, std::uint32_t i) {
    const double u = rng.uniform(i, 1);
    return i % 4 == 3 ? std::pow(10.0, -10.0 * u) : kPi * u;
}

/// Bounces about in a circle of `sides` walls, starting anywhere.
ExtremeCounts bounceAround(const SegmentIndex& index, const StopQuestion& stop) {
    const Rng rng(4, 0);
    const auto walls = static_cast<double>(index.scene().segments.size());
    ExtremeCounts counts;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        throwIfStopped(stop, i);
        const auto wall = static_cast<std::uint32_t>(walls * rng.uniform(i, 0));
        const ShadedPoint at = shadedPointOn(index, wall, rng.uniform(i, 2));
        const double theta = someAngle(rng, i);
        const Hit hit = index.closestHit(
            rayFrom(index, at, frameFromNormal(at.N).toWorld(halfCircleCos(theta), halfCircleSin(theta))));
        ++counts.rays;
        if (!hit || !hit.front) {
            ++counts.leaks;
        } else if (hit.segment == wall) {
            ++counts.selfHits;
        } else if (!std::isfinite(hit.t)) {
            ++counts.nonFinite;
        }
    }
    return counts;
}

/// The circle itself, by the quadratic equation of every textbook: |o + t d|^2 = r^2. Whether a point on it
/// lies inside is a difference of squares: mere rounding.
template <class Real>
ExtremeSide naiveCircle() {
    const Rng rng(4, 0);
    const auto least = static_cast<Real>(1e-4);
    ExtremeSide side;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        const auto phi = static_cast<Real>(2.0 * kPi * rng.uniform(i, 0));
        const auto theta = static_cast<Real>(someAngle(rng, i));
        const Real x = std::cos(phi), y = std::sin(phi), c = std::cos(theta), s = std::sin(theta);
        const Real dx = -y * c - x * s, dy = x * c - y * s;
        const Real b = x * dx + y * dy, rest = x * x + y * y - 1, square = b * b - rest;
        ++side.counts.rays;
        const Real root = std::sqrt(square), near = -b - root, far = -b + root;
        if (square >= 0 && near > least) {
            ++side.counts.selfHits;  // inside there is one hit only, the far one
        } else if (!(square >= 0) || !(far > least)) {
            ++side.counts.leaks;
        }
    }
    side.error = side.counts.lostShare();
    return side;
}

ExtremeOutcome millionWalls(const StopQuestion& stop) {
    constexpr std::uint32_t kWalls = 1'000'000;
    std::vector<Vec2> points;
    points.reserve(kWalls);
    for (std::uint32_t k = 0; k < kWalls; ++k) {
        const double angle = 2.0 * kPi * k / kWalls;
        points.emplace_back(std::cos(angle), std::sin(angle));
    }
    const Scene scene = furnaceOf(points, FurnaceQuestion{}.albedo);
    const SegmentIndex index(scene);
    ExtremeOutcome outcome;
    outcome.ours.counts = bounceAround(index, stop);
    FurnaceQuestion question;
    question.walls = 4;
    outcome.ours.error = furnaceError(scene, question, stop);
    outcome.naiveFloat = naiveCircle<float>();
    outcome.naiveDouble = naiveCircle<double>();
    outcome.words = "walls found by " + std::string(nameOf(kIndexMethods, index.method())) +
                    "; the naive twin has a circle instead, and compares squares of radii";
    return outcome;
}

}  // namespace

void addMeetingRows(std::vector<ExtremeCell>& cells) {
    cells.push_back({"circle:1e6", "a circle of a million walls", "E, relative; naive: rays lost",
                     furnaceBound(FurnaceQuestion{}.depth), "(4 D + 16) / 2 roundings for D bounces",
                     millionWalls});
    cells.push_back(
        {"coincident", "walls that lie on each other, up to rounding", "share of rays", 0.0,
         "which wall is met is a rule, not a rounding: the one that faces the ray, then the first",
         coincident});
    cells.push_back({"crossing", "a room of four walls that cross", "share of rays", 0.0,
                     "a crossing is no end of a wall: nothing is special there", crossing});
}

}  // namespace halfdisk
