#include "ray_race.h"

#include <algorithm>
#include <array>

#include "questions.h"
#include "timing.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostForBox2D = 10'000;
constexpr std::size_t kMostForBrute = 1'000;
// Walls asked by one brute check.
constexpr double kCheckWork = 2e8;

struct MethodName {
    IndexMethod method;
    const char* name;
};

constexpr std::array kMethods{MethodName{IndexMethod::everyWall, "every wall"},
                              MethodName{IndexMethod::bruteForce, "brute force"},
                              MethodName{IndexMethod::tree, "tree"}, MethodName{IndexMethod::grid, "grid"}};

const char* nameOf(IndexMethod method) {
    for (const MethodName& known : kMethods)
        if (known.method == method) return known.name;
    return "";
}

/// So many answers are checked that it takes about a second.
std::size_t checkedRays(const Scene& scene, Effort effort) {
    const double walls = effort == Effort::full ? kCheckWork : kCheckWork / 20.0;
    const double affordable = walls / static_cast<double>(scene.segments.size());
    const auto rays = std::clamp<std::size_t>(static_cast<std::size_t>(affordable), kFanRays, kPool);
    return rays / kFanRays * kFanRays;
}

/// Everything that is asked, in one scene.
struct Racers {
    explicit Racers(const Scene& scene) : own(scene) {
        const std::size_t segments = scene.segments.size();
        for (const MethodName& way : kMethods) {
            if (way.method == own.method()) continue;
            methods.push_back(std::make_unique<SegmentIndex>(scene, way.method));
        }
        twoTriangles = makeEmbree(scene, Extrusion::twoTriangles);
        oneTriangle = makeEmbree(scene, Extrusion::oneTriangle);
        if (segments <= 2 * kMostForBox2D) box2D = makeBox2D(scene);
    }
    SegmentIndex own;
    std::vector<std::unique_ptr<SegmentIndex>> methods;  // the others
    std::unique_ptr<Peer> twoTriangles, oneTriangle, box2D;
};

/// Whether a method takes part in the contest; if not, only its hits are checked.
bool isTimed(IndexMethod method, std::size_t segments) {
    if (method == IndexMethod::everyWall) return false;
    return method != IndexMethod::bruteForce || segments <= 2 * kMostForBrute;
}

constexpr const char* kOneTriangle = "Embree, 1 triangle";
constexpr const char* kTwoTriangles = "Embree, 2 triangles";
constexpr const char* kBox2D = "Box2D";

Race race(const QueryInfo& query, const Scene& scene, const Racers& racers, Effort effort) {
    const Questions questions = ask(query.query, scene, checkedRays(scene, effort));
    Answers answers(questions);
    Race race;
    race.query = &query;
    race.segments = scene.segments.size();
    race.checked = questions.checked;
    race.method = nameOf(racers.own.method());
    std::vector<Contender> contenders;
    // Each answers what is checked before it is timed.
    const auto check = [&](std::string who, bool isPeer, const Contender& contender) {
        answers.spoil();
        contender(0, questions.checked);
        race.laps.push_back({std::move(who), 0.0, answers.differences(isPeer)});
    };
    const auto own = [&](const SegmentIndex& index) -> Contender {
        return [&](std::size_t first, std::size_t count) { answers.by(index, first, count); };
    };
    const auto enterOwn = [&](const char* who, const SegmentIndex& index) {
        contenders.push_back(own(index));
        check(who, false, contenders.back());
    };
    const auto enterPeer = [&](const char* who, const std::unique_ptr<Peer>& peer, bool packets = false) {
        if (!peer) return;
        contenders.push_back(
            [&, packets](std::size_t first, std::size_t count) { answers.by(*peer, first, count, packets); });
        check(who, true, contenders.back());
    };
    enterOwn("Halfdisk", racers.own);
    for (const auto& index : racers.methods)
        if (isTimed(index->method(), race.segments)) enterOwn(nameOf(index->method()), *index);
    enterPeer(kOneTriangle, racers.oneTriangle);
    enterPeer(kTwoTriangles, racers.twoTriangles);
    if (query.query == Query::fan) enterPeer("Embree, packets of 16", racers.oneTriangle, true);
    enterPeer(kBox2D, racers.box2D);

    const bool full = effort == Effort::full;
    const Contest contest(contenders, {.items = kPool,
                                       .block = questions.block(),
                                       .turns = full ? 11 : 3,
                                       .turnSeconds = full ? 0.012 : 0.001});
    for (std::size_t i = 0; i < race.laps.size(); ++i) {
        Lap& lap = race.laps[i];
        lap.seconds = contest.secondsPerItem(i);
        const double over = contest.speedOver(0, i);
        if (lap.who == kBox2D) race.overBox2D = over;
        if (lap.who != kOneTriangle && lap.who != kTwoTriangles) continue;
        if (race.embree.empty() || over < race.overEmbree) {
            race.embree = lap.who;
            race.overEmbree = over;
        }
    }
    for (const auto& index : racers.methods)
        if (!isTimed(index->method(), race.segments)) check(nameOf(index->method()), false, own(*index));
    return race;
}

}  // namespace

std::vector<Race> raceRays(Pattern pattern, std::size_t size, Effort effort) {
    const Scene scene = makePattern(pattern, size);
    const Racers racers(scene);
    std::vector<Race> races;
    for (const QueryInfo& query : kQueries) {
        races.push_back(race(query, scene, racers, effort));
        races.back().size = size;
    }
    return races;
}

}  // namespace halfdisk
