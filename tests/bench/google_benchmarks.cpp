// How fast is one kind of question alone? The rays of the table under Google Benchmark's own command line, to
// look into one of them: --benchmark_filter=closest/random/1000, --benchmark_repetitions=9, ...
//
// Ratios are the table's business (halfdisk_bench): its contenders take turns.
#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include "questions.h"

using namespace halfdisk;

namespace {

/// One iteration is a batch, or a fan.
template <class Answerer>
void run(benchmark::State& state, const Answerer& answerer, Query query, const Scene& scene) {
    const Questions questions = ask(query, scene, 0);
    Answers answers(questions);
    const std::size_t count = query == Query::fan ? kFanRays : kBatch;
    std::size_t first = 0;
    for (auto _ : state) {
        answers.by(answerer, first, count);
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
