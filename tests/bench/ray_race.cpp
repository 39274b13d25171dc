#include "ray_race.h"

#include <algorithm>
#include <array>

#include "hit_check.h"
#include "timing.h"

namespace halfdisk {
namespace {

constexpr std::size_t kPool = 32'768;  // rays: small enough for the second-level cache
constexpr std::size_t kBatch = 4'096;
constexpr std::size_t kMostForBox2D = 10'000;
constexpr std::size_t kMostForBrute = 1'000;
// Walls asked by one brute check, about a second.
constexpr double kCheckWork = 4e8;
// m: what t may be off by in the unit box.
constexpr double kDoubleTolerance = 1e-9, kFloatTolerance = 1e-5;

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

/// The rays of one kind of question, and what is true of the first of them.
struct Questions {
    std::vector<Ray> rays;
    std::vector<double> tMax;
    std::vector<FloatRay> floats;
    std::vector<Hit> hits;              // brute: as many as are checked
    std::vector<std::uint8_t> answers;  // the same of any hit
};

Questions ask(Query query, const Scene& scene, Effort effort) {
    Questions questions;
    const bool any = query == Query::any || query == Query::anyBatch;
    if (any)
        questions.rays = pointPairs(scene, kPool, questions.tMax);
    else
        questions.rays =
            query == Query::fan ? halfDiskFans(scene, kPool / kFanRays) : incoherentRays(scene, kPool);
    questions.floats = floatRays(questions.rays, questions.tMax);
    const double work = effort == Effort::full ? kCheckWork : kCheckWork / 20.0;
    const double affordable = work / static_cast<double>(scene.segments.size());
    const auto checked = std::clamp<std::size_t>(static_cast<std::size_t>(affordable), kFanRays, kPool);
    for (std::size_t i = 0; i < checked / kFanRays * kFanRays; ++i)
        if (any)
            questions.answers.push_back(bruteOccluded(scene, questions.rays[i], questions.tMax[i]));
        else
            questions.hits.push_back(bruteClosest(scene, questions.rays[i]));
    return questions;
}

/// Calls `work(first, count)` for pieces of at most `piece`.
template <class Work>
void inPieces(std::size_t first, std::size_t count, std::size_t piece, const Work& work) {
    for (; count > 0; first += std::min(count, piece), count -= std::min(count, piece))
        work(first, std::min(count, piece));
}

/// Answers all questions of one kind, into its own place.
class Runner {
 public:
    Runner(Query query, const Questions& questions)
        : query_(query), questions_(questions), hits_(kPool), peerHits_(kPool), answers_(kPool) {}

    void run(const SegmentIndex& index, std::size_t first, std::size_t count) {
        const std::span rays(questions_.rays);
        const std::span hits(hits_);
        switch (query_) {
            case Query::closest:
                for (std::size_t i = first; i < first + count; ++i) hits[i] = index.closestHit(rays[i]);
                break;
            case Query::closestBatch:
                inPieces(first, count, kBatch, [&](std::size_t at, std::size_t size) {
                    index.closestHits(rays.subspan(at, size), hits.subspan(at, size));
                });
                break;
            case Query::any:
                for (std::size_t i = first; i < first + count; ++i)
                    answers_[i] = index.occluded(rays[i], questions_.tMax[i]);
                break;
            case Query::anyBatch:
                inPieces(first, count, kBatch, [&](std::size_t at, std::size_t size) {
                    index.occluded(rays.subspan(at, size), std::span(questions_.tMax).subspan(at, size),
                                   std::span(answers_).subspan(at, size));
                });
                break;
            case Query::fan:
                inPieces(first, count, kFanRays, [&](std::size_t at, std::size_t size) {
                    index.closestHitsFan(rays.subspan(at, size), hits.subspan(at, size));
                });
                break;
        }
    }

    void run(const Peer& peer, std::size_t first, std::size_t count, bool packets) {
        const auto rays = std::span(questions_.floats).subspan(first, count);
        const auto hits = std::span(peerHits_).subspan(first, count);
        if (query_ == Query::any || query_ == Query::anyBatch)
            peer.occluded(rays, std::span(answers_).subspan(first, count));
        else if (packets)
            peer.closestPackets(rays, hits);
        else
            peer.closest(rays, hits);
    }

    std::size_t differences(bool ofPeer) const {
        const std::size_t checked = std::max(questions_.hits.size(), questions_.answers.size());
        if (!questions_.answers.empty())
            return countDifferences(std::span(answers_).first(checked), questions_.answers);
        if (ofPeer)
            return countDifferences(std::span(peerHits_).first(checked), questions_.hits, kFloatTolerance);
        return countDifferences(std::span(hits_).first(checked), questions_.hits, kDoubleTolerance);
    }

 private:
    Query query_;
    const Questions& questions_;
    std::vector<Hit> hits_;
    std::vector<PeerHit> peerHits_;
    std::vector<std::uint8_t> answers_;
};

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
    const Questions questions = ask(query.query, scene, effort);
    const std::size_t checked = std::max(questions.hits.size(), questions.answers.size());
    Runner runner(query.query, questions);
    Race race;
    race.query = &query;
    race.segments = scene.segments.size();
    race.checked = checked;
    race.method = nameOf(racers.own.method());
    std::vector<Contender> contenders;
    // Each answers what is checked before it is timed.
    const auto enter = [&](std::string who, bool isPeer, Contender contender) {
        contender(0, checked);
        race.laps.push_back({std::move(who), 0.0, runner.differences(isPeer)});
        contenders.push_back(std::move(contender));
    };
    const auto enterOwn = [&](const char* who, const SegmentIndex& index) {
        enter(who, false, [&](std::size_t first, std::size_t count) { runner.run(index, first, count); });
    };
    const auto enterPeer = [&](const char* who, const std::unique_ptr<Peer>& peer, bool packets = false) {
        if (!peer) return;
        enter(who, true, [&, packets](std::size_t first, std::size_t count) {
            runner.run(*peer, first, count, packets);
        });
    };
    enterOwn("Halfdisk", racers.own);
    for (const auto& index : racers.methods)
        if (isTimed(index->method(), race.segments)) enterOwn(nameOf(index->method()), *index);
    enterPeer(kOneTriangle, racers.oneTriangle);
    enterPeer(kTwoTriangles, racers.twoTriangles);
    if (query.query == Query::fan) enterPeer("Embree, packets of 16", racers.oneTriangle, true);
    enterPeer(kBox2D, racers.box2D);

    const bool full = effort == Effort::full;
    const Contest contest(
        contenders,
        {.items = kPool, .block = kFanRays, .turns = full ? 15 : 3, .turnSeconds = full ? 0.015 : 0.001});
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
    for (const auto& index : racers.methods) {
        if (isTimed(index->method(), race.segments)) continue;
        runner.run(*index, 0, checked);
        race.laps.push_back({nameOf(index->method()), 0.0, runner.differences(false)});
    }
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
