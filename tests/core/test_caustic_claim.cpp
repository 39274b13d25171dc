// Is the lesson right that caustics are the nightmare of backward sampling? The error of each estimator at
// equal rays.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "agreement.h"
#include "caustic.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// The glass disk over the floor, lit by a lamp of 2 mm six metres above its middle instead of the sun.
Stage lampStage() {
    CausticSetup setup;
    Stage stage;
    stage.name = "caustic of a lamp";
    stage.scene = causticScene(setup, 128, true);
    stage.scene.lights.clear();
    Segment lamp;
    lamp.a = {0.001, setup.height + 6.0};
    lamp.b = {-0.001, setup.height + 6.0};
    lamp.material = 1;
    lamp.emission = Rgb(100.0);
    stage.scene.segments.push_back(lamp);
    stage.scene.segmentNames.push_back("lamp");
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    return stage;
}

/// Root of the mean square difference over the bins below the disk, over the mean of the truth; the truth's
/// own error is taken off.
double relativeError(const Film& film, const Film& truth) {
    double square = 0.0, mean = 0.0;
    const std::size_t first = film.pixels.size() / 3, last = 2 * first;
    for (std::size_t i = first; i < last; ++i) {
        square += std::pow(film.pixels[i].mean.x - truth.pixels[i].mean.x, 2) -
                  std::pow(truth.pixels[i].standardError().x, 2);
        mean += truth.pixels[i].mean.x;
    }
    return std::sqrt(std::max(square, 0.0) * static_cast<double>(last - first)) / mean;
}

}  // namespace

TEST_CASE("caustic: at equal rays half-disk sampling is off by 20 times more than forward methods") {
    const Stage stage = lampStage();
    const std::uint32_t bins = 60;
    const Sensor floor = Profile{{stage.wall("floor")}, bins};
    // Light tracing by 4 million paths, of other random numbers: its error is known, and taken off.
    Run truthRun{.id = "light",
                 .params = {{"paths", 20'000}, {"spread", 1}},
                 .maxDepth = 0,
                 .seed = 77,
                 .samples = bins * 200,
                 .threads = 2};
    const Film truth = measure(stage, floor, truthRun);

    struct Row {
        Run run;
        double error = 0.0;
        std::uint64_t rays = 0;
    };
    std::vector<Row> rows{
        {{.id = "cast-ray", .params = {{"samples", 16}}, .maxDepth = 0}},
        {{.id = "cast-ray", .params = {{"samples", 16}, {"emitters", 1}}, .maxDepth = 0}},
        {{.id = "path", .maxDepth = 0}},
        {{.id = "light", .maxDepth = 0}},
        {{.id = "photon-map",
          .params = {{"photons", 500}, {"gather", 0}, {"radius", 0.02}, {"caustic-radius", 0.02}},
          .maxDepth = 0}},
        {{.id = "bidirectional", .maxDepth = 0}},
    };
    constexpr double kRays = 500'000.0;
    for (Row& row : rows) {
        row.run.threads = 2;
        // A small run tells what a pass costs.
        row.run.samples = bins;
        const double perPass = static_cast<double>(measure(stage, floor, row.run).counts.rays);
        row.run.samples = static_cast<std::uint64_t>(kRays / perPass * bins);
        // The error of one run is itself a matter of luck: the mean square over several runs.
        double square = 0.0;
        constexpr int kRuns = 6;
        for (int run = 0; run < kRuns; ++run) {
            row.run.seed = static_cast<std::uint64_t>(run) + 1;
            const Film film = measure(stage, floor, row.run);
            square += std::pow(relativeError(film, truth), 2);
            row.rays = film.counts.rays;
        }
        row.error = std::sqrt(square / kRuns);
        std::string params;
        for (const auto& [name, value] : row.run.params) params += fmt::format(" {}={:g}", name, value);
        MESSAGE(fmt::format("{:<14}{:<60} {:>8} rays, relative error {:.4f}", row.run.id, params, row.rays,
                            row.error));
    }
    // The lesson's castRay against both forward methods; met by chance, lamps are found a little more often
    // (shadow rays cost half of the others'), and it takes light tracing to be so much better.
    CHECK(rows[0].error > 20.0 * rows[3].error);
    CHECK(rows[0].error > 20.0 * rows[4].error);
    CHECK(rows[1].error > 20.0 * rows[3].error);
}
