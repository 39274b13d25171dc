// How fast is one kind of question alone? The rays of the table under Google Benchmark's own command line, to
// look into one of them: --benchmark_filter=closest/random/1000, --benchmark_repetitions=9, ...
//
// Ratios are the table's business (halfdisk_bench): its contenders take turns.
#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <functional>

#include "peers.h"
#include "required.h"

using namespace halfdisk;

namespace {

constexpr std::size_t kPool = 32'768;
constexpr std::size_t kBatch = 4'096;

struct Questions {
    std::vector<Ray> rays;
    std::vector<double> tMax;
    std::vector<FloatRay> floats;
    std::vector<Hit> hits = std::vector<Hit>(kPool);
    std::vector<PeerHit> peerHits = std::vector<PeerHit>(kPool);
    std::vector<std::uint8_t> answers = std::vector<std::uint8_t>(kPool);
};

Questions ask(Query query, const Scene& scene) {
    Questions q;
    if (query == Query::any || query == Query::anyBatch)
        q.rays = pointPairs(scene, kPool, q.tMax);
    else
        q.rays = query == Query::fan ? halfDiskFans(scene, kPool / kFanRays) : incoherentRays(scene, kPool);
    q.floats = floatRays(q.rays, q.tMax);
    return q;
}

/// Answers rays first ... first + count - 1; the count divides kPool.
void answer(const SegmentIndex& index, Query query, Questions& q, std::size_t first, std::size_t count) {
    const auto rays = std::span<const Ray>(q.rays).subspan(first, count);
    const auto hits = std::span(q.hits).subspan(first, count);
    switch (query) {
        case Query::closest:
            for (std::size_t i = 0; i < count; ++i) hits[i] = index.closestHit(rays[i]);
            break;
        case Query::closestBatch:
            index.closestHits(rays, hits);
            break;
        case Query::any:
            for (std::size_t i = 0; i < count; ++i) q.answers[i] = index.occluded(rays[i], q.tMax[first + i]);
            break;
        case Query::anyBatch:
            index.occluded(rays, std::span(q.tMax).subspan(first, count),
                           std::span(q.answers).subspan(first, count));
            break;
        case Query::fan:
            index.closestHitsFan(rays, hits);
            break;
    }
}

void answer(const Peer& peer, Query query, Questions& q, std::size_t first, std::size_t count) {
    const auto rays = std::span<const FloatRay>(q.floats).subspan(first, count);
    if (query == Query::any || query == Query::anyBatch)
        peer.occluded(rays, std::span(q.answers).subspan(first, count));
    else
        peer.closest(rays, std::span(q.peerHits).subspan(first, count));
}

/// One iteration is a batch, or a fan.
template <class Answerer>
void run(benchmark::State& state, const Answerer& answerer, Query query, const Scene& scene) {
    Questions questions = ask(query, scene);
    const std::size_t count = query == Query::fan ? kFanRays : kBatch;
    std::size_t first = 0;
    for (auto _ : state) {
        answer(answerer, query, questions, first, count);
        benchmark::ClobberMemory();
        first = (first + count) % kPool;
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(count) * state.iterations());
}

void runOwn(benchmark::State& state, IndexMethod method, Query query, Pattern pattern, std::size_t size) {
    const Scene scene = makePattern(pattern, size);
    run(state, SegmentIndex(scene, method), query, scene);
}

template <class MakePeer>
void runPeer(benchmark::State& state, MakePeer makePeer, Query query, Pattern pattern, std::size_t size) {
    const Scene scene = makePattern(pattern, size);
    if (const std::unique_ptr<Peer> peer = makePeer(scene))
        run(state, *peer, query, scene);
    else
        state.SkipWithError("not installed");
}

void registerAll(const QueryInfo& query, Pattern pattern, std::size_t size) {
    const auto add = [&](const char* who, auto function) {
        benchmark::RegisterBenchmark(
            fmt::format("{}/{}/{}/{}", query.id, infoOf(pattern).name, size, who).c_str(), function);
    };
    const Query asked = query.query;
    const auto addOwn = [&](const char* name, IndexMethod method) {
        add(name, [=](benchmark::State& state) { runOwn(state, method, asked, pattern, size); });
    };
    addOwn("automatic", IndexMethod::automatic);
    addOwn("bruteForce", IndexMethod::bruteForce);
    addOwn("tree", IndexMethod::tree);
    addOwn("grid", IndexMethod::grid);
    add("embree", [=](benchmark::State& state) {
        runPeer(
            state, [](const Scene& scene) { return makeEmbree(scene, Extrusion::oneTriangle); }, asked,
            pattern, size);
    });
    if (size > 10'000) return;
    add("box2d", [=](benchmark::State& state) { runPeer(state, makeBox2D, asked, pattern, size); });
}

}  // namespace

int main(int argc, char** argv) {
    for (const QueryInfo& query : kQueries)
        for (const Pattern pattern : {Pattern::random, Pattern::circles, Pattern::fractal})
            for (const std::size_t size : kSizes) registerAll(query, pattern, size);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
