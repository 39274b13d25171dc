// How long does it take to build the index, and how large is it, beside Embree's?
#include <fmt/format.h>

#include "benches.h"
#include "peers.h"
#include "required.h"
#include "timing.h"

namespace halfdisk {
namespace {

double secondsToBuild(const Scene& scene) {
    const double start = processSeconds();
    const SegmentIndex index(scene);
    return processSeconds() - start;
}

struct Builds {
    std::vector<double> own, oneTriangle, twoTriangles;  // s
    double embreeBytes = 0.0;                            // of oneTriangle
};

Builds buildInTurns(const Scene& scene, int turns) {
    Builds builds;
    for (int turn = -1; turn < turns; ++turn) {  // the first warms up
        const double own = secondsToBuild(scene);
        const auto one = makeEmbree(scene, Extrusion::oneTriangle);
        const auto two = makeEmbree(scene, Extrusion::twoTriangles);
        if (turn < 0) continue;
        builds.own.push_back(own);
        if (!one || !two) continue;
        builds.oneTriangle.push_back(one->buildSeconds());
        builds.twoTriangles.push_back(two->buildSeconds());
        builds.embreeBytes = one->bytes();
    }
    return builds;
}

double medianRatio(const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < above.size(); ++i) ratios.push_back(above[i] / below[i]);
    return quantile(ratios, 0.5);
}

void benchOne(Report& report, Pattern pattern, std::size_t size, bool full) {
    const Scene scene = makePattern(pattern, size);
    const double segments = static_cast<double>(scene.segments.size());
    const int turns = !full ? 2 : size > 300'000 ? 5 : size > 30'000 ? 9 : 31;
    const Builds builds = buildInTurns(scene, turns);
    const SegmentIndex index(scene);
    const double bytes = static_cast<double>(index.bytes()) / segments, own = quantile(builds.own, 0.5);
    const std::string what = fmt::format("{}, n = {}", infoOf(pattern).name, size);
    nlohmann::ordered_json row{{"scene", infoOf(pattern).name},
                               {"segments", scene.segments.size()},
                               {"seconds", own},
                               {"bytesPerSegment", bytes}};
    report.progress("");
    const auto sizeMark = report.judge("bytes per segment, " + what, bytes, std::nullopt, kBytesPerSegment);
    report.print("{:>8} {:>9} {:>11.3f} {:>7.1f} {:>6}", infoOf(pattern).name, scene.segments.size(),
                 1e3 * own, bytes, sizeMark);
    if (!builds.oneTriangle.empty()) {
        const double ratio = medianRatio(builds.own, builds.oneTriangle);
        const double loose = medianRatio(builds.own, builds.twoTriangles);
        const auto mark = report.judge("build time over Embree's, " + what, ratio, std::nullopt, kBuildShare);
        report.print(" {:>11.3f} {:>7.1f} {:>7.2f} {:>6} {:>11.3f} {:>7.2f}",
                     1e3 * quantile(builds.oneTriangle, 0.5), builds.embreeBytes / segments, ratio, mark,
                     1e3 * quantile(builds.twoTriangles, 0.5), loose);
        row["shareOfEmbree"] = ratio;
        row["shareOfEmbreeTwoTriangles"] = loose;
        row["embreeSeconds"] = quantile(builds.oneTriangle, 0.5);
        row["embreeTwoTrianglesSeconds"] = quantile(builds.twoTriangles, 0.5);
        row["embreeBytesPerSegment"] = builds.embreeBytes / segments;
    }
    report.print("\n");
    report.add("build", row);
}

void benchRebuild(Report& report, bool full) {
    Scene scene = makePattern(Pattern::random, 10'000);
    std::vector<double> times;
    for (int turn = 0; turn < (full ? 51 : 3); ++turn) {
        scene.segments[static_cast<std::size_t>(turn) * 97].a.x += 1e-3;
        times.push_back(secondsToBuild(scene));
    }
    const double median = quantile(times, 0.5), high = quantile(times, 0.95);
    report.print(
        "\none of 10 000 segments is moved: ready again after {:.2f} ms (95 %: {:.2f} ms; required < {:g}) "
        "{}\n",
        1e3 * median, 1e3 * high, 1e3 * kRebuildSeconds,
        report.judge("ms to rebuild 10 000 segments", 1e3 * high, std::nullopt, 1e3 * kRebuildSeconds));
    report.add("rebuild", {{"segments", 10'000}, {"seconds", median}, {"p95", high}});
}

}  // namespace

void benchBuild(Report& report, Effort effort) {
    const bool full = effort == Effort::full;
    report.print(
        "Time to build and size of the index; Embree: rtcCommitScene, medium quality, one thread (share: "
        "required "
        "<= {:g}, bytes <= {:g})\n",
        kBuildShare, kBytesPerSegment);
    for (const std::string& missing : missingPeers()) report.print("{}\n", missing);
    report.print("{:>8} {:>9} {:>11} {:>7} {:>6} {:>11} {:>7} {:>7} {:>6} {:>11} {:>7}\n", "scene", "n", "ms",
                 "bytes/n", "", "Embree1 ms", "bytes/n", "share", "", "Embree2 ms", "share");
    for (const Pattern pattern : {Pattern::random, Pattern::circles, Pattern::fractal})
        for (const std::size_t size : kSizes) {
            if (size < 1000 || (!full && size > 1000)) continue;
            if (full && pattern == Pattern::fractal && size != kSizes.back()) continue;
            report.progress(fmt::format("{}, n = {}", infoOf(pattern).name, size));
            benchOne(report, pattern, size, full);
        }
    benchRebuild(report, full);
}

}  // namespace halfdisk
