// Do estimators of independent design find the same light? Scenes, sensors, and the tests between two films.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/estimate.h"
#include "core/estimators.h"
#include "core/reference.h"
#include "core/render.h"
#include "support.h"

namespace halfdisk::test {

/// A scene of tests/scenes, ready to be measured.
struct Stage {
    std::string name;
    Scene scene;
    std::unique_ptr<SegmentIndex> index;

    std::uint32_t wall(const std::string& wallName) const;
};

/// Reads tests/scenes/NAME.toml, with `finer` times as many walls in all that is round. Throws for anything
/// that is missing.
Stage readStage(const std::string& name, std::uint32_t finer = 1);

/// One of each kind in a stage: a probe and a profile on its wall "floor", its eye, a field over all of it.
std::vector<Sensor> sensorsOf(const Stage& stage);

struct Run {
    std::string id;                                        ///< of the estimator
    std::vector<std::pair<std::string, double>> params{};  ///< others than the default
    std::uint32_t maxDepth = 2;
    std::uint32_t maxSpecular = kMaxSpecularInfo.initial;
    std::uint64_t seed = 1;
    std::uint64_t samples = 100'000;  ///< pixels times passes, about
    unsigned threads = 1;
};

ParamValues valuesOf(const EstimatorInfo& info, const std::vector<std::pair<std::string, double>>& params);

/// Throws std::invalid_argument with its message where the estimator refuses.
Film measure(const Stage& stage, const Sensor& sensor, const Run& run);

/// Largest difference of two films over pixels and channels, in standard errors of the difference, and the
/// threshold that equal means pass with probability 1 - 1e-4 (Bonferroni over all of them, times
/// `comparisons` such films).
struct Agreement {
    double worst = 0.0;
    double threshold = 0.0;
    std::string where;

    bool holds() const { return worst <= threshold; }
};
Agreement compare(const Film& a, const Film& b, std::size_t comparisons);

/// The same against exact values with absolute error bounds.
Agreement compareExact(const Film& film, const std::vector<Rgb>& exact, double err, std::size_t comparisons);

/// Irradiance on a wall as means over `bins` equal parts of it, by eight Gauss points on each of `panels`
/// pieces of a bin: edges of shadows and covers that lie between pieces cost nothing.
std::vector<Rgb> exactBins(const Stage& stage, const Reference& reference, std::uint32_t wall,
                           std::size_t bins, std::size_t panels, std::uint32_t depth);

}  // namespace halfdisk::test
