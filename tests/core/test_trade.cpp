// Does a trade tell the truth of estimators whose noise and bias are known beforehand?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "core/trade/trade_choice.h"

using namespace halfdisk;

namespace {

constexpr std::uint32_t kPixels = 12;

/// Pixels share a part of their noise, as those of light paths do.
struct Made {
    double bias = 0.0, sigma = 1.0, shared = 0.0;
    std::uint64_t seed = 1;
};

double truthAt(std::uint32_t pixel) {
    return 1.0 + 0.1 * pixel;
}

class MadeEstimator : public Estimator {
 public:
    explicit MadeEstimator(const Made& made) : made_(made) {}
    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        const Rng rng(made_.seed, pass);
        const auto noise = [](const Rng& from) { return (from.uniform(0, 0) - 0.5) * std::sqrt(12.0); };
        const double all = noise(rng);
        for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
            const double own = noise(rng.child(pixel + 1));
            picture[pixel] +=
                Rgb(truthAt(pixel) + made_.bias +
                    made_.sigma * (std::sqrt(made_.shared) * all + std::sqrt(1.0 - made_.shared) * own));
        }
        counts.rays += 10;
    }

 private:
    Made made_;
};

TradeReference truth() {
    TradeReference reference;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) reference.mean.emplace_back(truthAt(pixel));
    return reference;
}

GroupedPasses passesOf(const Made& made, std::uint64_t passes, unsigned threads = 1) {
    PassBudget budget;
    budget.rays = 10.0 * static_cast<double>(passes);
    budget.threads = threads;
    return runGroups(MadeEstimator(made), kPixels, {}, budget, {});
}

/// A reference that is a run itself, without bias.
TradeReference noisyTruth(std::uint64_t seed, std::uint64_t passes, double sigma = 1.0) {
    const GroupedPasses run = passesOf({.sigma = sigma, .seed = seed + 1'000'000}, passes);
    TradeReference reference = truth();
    reference.groups = run.groups.means;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        Rgb sum{0.0};
        for (const Picture& group : reference.groups) sum += group[pixel];
        reference.mean[pixel] = sum / static_cast<double>(reference.groups.size());
    }
    return reference;
}

/// Mean and standard error of what many runs tell.
struct Told {
    Statistics values;
    void add(double value) { values.add(Rgb(value)); }
    double mean() const { return values.mean.x; }
    double error() const { return values.standardError().x; }
};

const EstimatorInfo& pathInfo() {
    return *findEstimator("path");
}

/// A measured cell as if `path` had been made so.
TradeCell cellOf(const GroupedPasses& run, const TradeReference& reference) {
    TradeCell cell;
    cell.setting = {&pathInfo(), initialValues(pathInfo()), 1};
    cell.passes = run.groups.passes();
    cell.groups = run.groups.means.size();
    cell.rays = run.counts.rays;
    cell.seconds = 1e-3;
    cell.statistics = statisticsOf(run.groups, reference);
    return cell;
}

}  // namespace

TEST_CASE("trade: the same bits on any number of threads, and groups that are joined keep their mean") {
    const Made made{.bias = 0.1, .shared = 0.5};
    const GroupedPasses one = passesOf(made, 1000, 1), three = passesOf(made, 1000, 3);
    CHECK(one.groups.each == three.groups.each);
    CHECK(one.groups.means == three.groups.means);
    CHECK(one.counts.rays == three.counts.rays);
    CHECK(one.groups.passes() >= 1000);
    CHECK(one.groups.passes() < 1100);
    CHECK(one.groups.means.size() > PassGroups::kMost / 2);
    PassGroups joined = one.groups;
    if (joined.means.size() % 2 == 1) joined.means.pop_back();
    const double before = (joined.means[0][3].x + joined.means[1][3].x) / 2.0;
    joined.joinNeighbours();
    CHECK(joined.means[0][3].x == doctest::Approx(before).epsilon(1e-15));
    CHECK(joined.each == 2 * one.groups.each);
}

TEST_CASE(
    "trade: variance and bias are unbiased, whatever pixels share and however uncertain the reference is") {
    constexpr std::uint64_t kRuns = 300;
    for (const double shared : {0.0, 0.9})
        for (const bool noisy : {false, true}) {
            Told variance, bias2, naive;
            for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
                const TradeReference reference = noisy ? noisyTruth(seed, 128) : truth();
                const GroupedPasses run =
                    passesOf({.bias = 0.1, .sigma = 2.0, .shared = shared, .seed = seed}, 800);
                const TradeStatistics told = statisticsOf(run.groups, reference);
                variance.add(told.variance.value);
                bias2.add(told.bias2.value);
                TradeReference believed = reference;
                believed.groups.clear();
                naive.add(statisticsOf(run.groups, believed).bias2.value);
            }
            INFO(fmt::format("shared {} noisy {}", shared, noisy));
            CHECK(std::abs(variance.mean() - 4.0) < 4.0 * variance.error());
            CHECK(variance.error() < 0.08);
            CHECK(std::abs(bias2.mean() - 0.01) < 4.0 * bias2.error());
            CHECK(bias2.error() < 0.003);
            // Without its own error taken off, an uncertain reference would pass for bias.
            if (noisy) CHECK(naive.mean() - 0.01 > 4.0 * naive.error());
        }
}

TEST_CASE(
    "trade: the intervals hold what they should, and their standard errors are those that many runs show") {
    constexpr std::uint64_t kRuns = 400;
    for (const double bias : {0.0, 0.05, 0.3})
        for (const double shared : {0.0, 0.9}) {
            std::uint64_t inside = 0;
            Told bias2, predicted;
            for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
                const TradeReference reference = noisyTruth(seed, 512);
                const GroupedPasses run = passesOf({.bias = bias, .shared = shared, .seed = seed}, 640);
                const TradeStatistics all = statisticsOf(run.groups, reference);
                const std::uint64_t groups = run.groups.means.size();
                const Uncertain told = all.bias2;
                inside +=
                    bias2Low(all, groups) <= bias * bias && bias * bias <= bias2High(all, groups) ? 1 : 0;
                bias2.add(told.value);
                predicted.add(told.error);
            }
            const double share = static_cast<double>(inside) / kRuns;
            const double spread = std::sqrt(bias2.values.variance().x);
            INFO(fmt::format("bias {} shared {}: {} inside, spread {}, predicted {}", bias, shared, share,
                             spread, predicted.mean()));
            CHECK(share > 0.91);
            // The jackknife of a product is never too small on average, and at most twice too large.
            CHECK(predicted.mean() > 0.8 * spread);
            CHECK(predicted.mean() < 2.0 * spread);
        }
}

TEST_CASE("trade: noise falls with the power -1/2, and flatter where a bias is left") {
    Told exponents, flat;
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
        for (const double bias : {0.0, 0.2}) {
            std::vector<TradeLevel> levels;
            PassBudget budget;
            budget.rays = 10.0 * 16384;
            runGroups(MadeEstimator({.bias = bias, .seed = seed}), kPixels, {}, budget, {},
                      [&](const GroupedPasses& run) {
                          levels.push_back(
                              {static_cast<double>(run.groups.each), statisticsOf(run.groups, truth()).mse});
                      });
            CHECK(levels.size() >= 8);
            const auto exponent = exponentOf(levels);
            REQUIRE(exponent);
            (bias == 0.0 ? exponents : flat).add(exponent->value);
        }
    CHECK(std::abs(exponents.mean() + 0.5) < 0.01);
    CHECK(flat.mean() > -0.4);
}

TEST_CASE("trade: what is five percent too bright is told, what is not is left alone") {
    std::uint64_t told = 0, wronged = 0;
    constexpr std::uint64_t kRuns = 100;
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed)
        for (const double bias : {0.0, 0.05}) {
            const TradeReference reference = noisyTruth(seed, 2048, 0.1);
            const GroupedPasses run =
                passesOf({.bias = bias, .sigma = 0.1, .shared = 0.5, .seed = seed}, 2048);
            const TradeReport report =
                tradeReport({cellOf(run, reference)}, {reference.light(), 0.0, false, 1}, 0.05);
            (bias > 0.0 ? told : wronged) += report.verdicts[0].biased ? 1 : 0;
        }
    CHECK(told >= 95);
    CHECK(wronged <= 1);
}

TEST_CASE("trade: light that few passes have not found is no bias, and what many show is one") {
    // One pass in 200 brings 200, the others nothing: the mean is 1.
    constexpr double kRare = 200.0;
    const auto run = [&](std::uint64_t seed, std::uint64_t passes, double factor) {
        PassGroups groups;
        for (std::uint64_t group = 0; group < 16; ++group) {
            double sum = 0.0;
            for (std::uint64_t pass = 0; pass < passes / 16; ++pass) {
                const Rng rng(seed, group * passes + pass);
                sum += rng.uniform(0, 0) < 1.0 / kRare ? factor * kRare : 1e-9 * rng.uniform(1, 0);
            }
            groups.means.push_back({Rgb(16.0 * sum / static_cast<double>(passes))});
        }
        groups.each = passes / 16;
        GroupedPasses made;
        made.groups = groups;
        return made;
    };
    TradeReference reference;
    reference.mean = {Rgb(1.0)};
    std::uint64_t wronged = 0, spread = 0, told = 0, cheap = 0;
    constexpr std::uint64_t kRuns = 100;
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
        const auto isSure = [&](std::uint64_t passes, double factor, bool unseen) {
            TradeCell cell = cellOf(run(seed, passes, factor), reference);
            if (unseen) cell.unseen = 3.0 * kRare / static_cast<double>(passes);
            const TradeReport report = tradeReport({cell}, {1.0, 0.0, true, 1}, 0.05);
            // What was not found is not forgotten: it counts as noise of that size.
            if (unseen && passes == 64) cheap += *report.verdicts[0].law.passesTo(0.05) < 1000.0 ? 1 : 0;
            return report.verdicts[0].biased;
        };
        wronged += isSure(64, 1.0, true) ? 1 : 0;
        spread += isSure(64, 1.0, false) ? 1 : 0;
        told += isSure(256'000, 2.0, true) ? 1 : 0;
    }
    CHECK(wronged == 0);
    CHECK(cheap == 0);          // in truth 80 000 passes
    CHECK(spread > kRuns / 2);  // by the groups' spread alone, nothing at all would be sure
    CHECK(told == kRuns);
}

namespace {

/// A cell with this variance of a pass, and bias, exactly known, in a picture whose light is 1.
TradeCell lawful(const EstimatorInfo& info, double variance, double bias, std::uint64_t raysPerPass,
                 double seconds, double preparation = 0.0) {
    TradeCell cell;
    cell.setting = {&info, initialValues(info), 1};
    cell.name = info.id;
    cell.passes = 100;
    cell.groups = 25;
    cell.rays = 100 * raysPerPass;
    cell.seconds = 100.0 * seconds;
    cell.preparationSeconds = preparation;
    cell.statistics.variance = {variance, 0.01 * variance};
    cell.statistics.bias2 = {bias * bias, 1e-9};
    cell.statistics.mean = 1.0;
    return cell;
}

}  // namespace

TEST_CASE("trade: front, crossing, factors and choices of laws that are known") {
    const EstimatorInfo &path = *findEstimator("path"), &radiosity = *findEstimator("radiosity"),
                        &cast = *findEstimator("cast-ray");
    // By rays: path 100 / e^2 rays, radiosity 1 / (e^2 - 0.01^2), castRay 1000 / e^2.
    const TradeReport report =
        tradeReport({lawful(path, 1.0, 0.0, 100, 1e-3), lawful(radiosity, 0.01, 0.01, 100, 1e-3, 2.0),
                     lawful(cast, 10.0, 0.0, 100, 1e-2)},
                    {1.0, 0.0, true, 1}, 0.05);
    const auto& verdicts = report.verdicts;
    CHECK(*verdicts[0].toTarget[0] == doctest::Approx(100.0 / 0.0025));
    CHECK(*verdicts[1].toTarget[0] == doctest::Approx(1.0 / (0.0025 - 0.0001)));
    CHECK(*verdicts[2].offAtTarget[0] == doctest::Approx(1000.0 / 0.0025 * (0.0025 - 0.0001)));
    CHECK_FALSE(verdicts[1].law.costOf(0.01, TradeCost::rays));
    CHECK(*verdicts[0].off[0] == doctest::Approx(1.0));
    // castRay costs ten times path's rays at best, a hundred times its seconds, but for one pass.
    CHECK(*verdicts[2].off[0] > 1.0);
    CHECK(verdicts[2].nobody);
    CHECK_FALSE(verdicts[0].nobody);
    CHECK_FALSE(verdicts[1].nobody);
    // Equal rays where e^2 - 0.01^2 = e^2 / 100: the next error that is looked at lies within 12 %.
    REQUIRE(report.crossings[0].size() >= 1);
    bool found = false;
    for (const TradeCrossing& crossing : report.crossings[0])
        if (crossing.coarse == &radiosity && crossing.fine == &path) {
            found = true;
            CHECK(crossing.error == doctest::Approx(0.01 / std::sqrt(0.99)).epsilon(0.12));
        }
    CHECK(found);

    const auto exact = choose(report, {TradeCost::rays, 0.003});
    REQUIRE(exact);
    CHECK(exact->cell == 0);
    CHECK(exact->passes == static_cast<std::uint64_t>(std::ceil(1.0 / (0.003 * 0.003))));
    CHECK(exact->relativeError <= 0.003 * (1 + 1e-12));
    CHECK(exact->runnerUp == 2);
    CHECK(exact->runnerUpFactor == doctest::Approx(10.0));
    // A second is too little to prepare radiosity; with three it has the least error.
    CHECK(choose(report, {TradeCost::seconds, {}, 1.0})->cell == 0);
    CHECK(choose(report, {TradeCost::seconds, {}, 3.0})->cell == 1);
    CHECK_FALSE(choose(report, {TradeCost::seconds, {}, 1e-6}));
}

TEST_CASE("trade: runs that are the same are one, by the better of their times") {
    const EstimatorInfo &path = *findEstimator("path"), &cast = *findEstimator("cast-ray");
    TradeCell early = lawful(path, 1.0, 0.0, 100, 3e-3), late = lawful(path, 1.0, 0.0, 100, 1e-3),
              other = lawful(cast, 1.0, 0.0, 100, 2e-3);
    for (TradeCell* cell : {&early, &late, &other})
        cell->levels = {{1, {0.5, 0.1}, 3200}, {2, {0.25, 0.1}, 6400}};
    late.setting.params.back() += 12.0;
    CHECK(isSameRun(early, late));
    CHECK_FALSE(isSameRun(early, other));
    const TradeReport report = tradeReport({early, late, other}, {1.0, 0.0, true, 1}, 0.05);
    CHECK_FALSE(report.verdicts[0].sameRunAs);
    CHECK(report.verdicts[1].sameRunAs == std::size_t{0});
    for (const std::size_t same : {0, 1}) {
        CHECK(*report.verdicts[same].toTarget[1] == doctest::Approx(400.0 * 1e-3));
        CHECK_FALSE(report.verdicts[same].nobody);
    }
    CHECK(report.isOnFront(0, TradeCost::seconds));
    CHECK_FALSE(report.isOnFront(1, TradeCost::seconds));
    // Other passes: as far as both went. One number, or one ray, that differs, and they are two.
    TradeCell longer = late;
    longer.passes *= 4;
    longer.levels.push_back({4, {0.125, 0.1}, 12800});
    CHECK(isSameRun(early, longer));
    longer.levels[1].mse.value = 0.26;
    CHECK_FALSE(isSameRun(early, longer));
    longer.levels[1] = {2, {0.25, 0.1}, 6401};
    CHECK_FALSE(isSameRun(early, longer));
    late.setting.index = IndexMethod::single;
    CHECK_FALSE(isSameRun(early, late));
}

TEST_CASE("trade: of what is as cheap the less biased one is on the front") {
    const EstimatorInfo &photons = *findEstimator("photon-map"), &radiosity = *findEstimator("radiosity");
    const TradeReport report =
        tradeReport({lawful(photons, 1e-4, 0.3, 100, 1e-3), lawful(radiosity, 1e-4, 0.01, 100, 1e-3)},
                    {1.0, 0.0, true, 1}, 0.05);
    for (const auto& cost : kTradeCosts) {
        CHECK_FALSE(report.isOnFront(0, cost.value));
        CHECK(report.isOnFront(1, cost.value));
    }
}

TEST_CASE("trade: what a slower machine, or a spread of times, leaves open is not told for sure") {
    const EstimatorInfo &path = *findEstimator("path"), &cast = *findEstimator("cast-ray");
    const auto isNobody = [&](double slowPace, double spread) {
        TradeCell fast = lawful(path, 1.0, 0.0, 100, 1e-3), slow = lawful(cast, 1.1, 0.0, 110, 2e-3);
        fast.paceSeconds = 1e-3;
        slow.paceSeconds = slowPace;
        slow.secondsError = spread * slow.seconds;
        const TradeReport report = tradeReport({fast, slow}, {1.0, 0.0, true, 1}, 0.05);
        CHECK(report.verdicts[1].dominated[0]);
        CHECK(report.verdicts[1].slower == doctest::Approx(slowPace > 0.0 ? slowPace / 1e-3 : 1.0));
        return report.verdicts[1].nobody;
    };
    CHECK(isNobody(1e-3, 0.0));
    CHECK(isNobody(0.0, 0.0));  // an older file: not known
    CHECK_FALSE(isNobody(2e-3, 0.0));
    CHECK_FALSE(isNobody(1e-3, 0.25));
    CHECK(isNobody(1e-3, 0.02));
}

TEST_CASE("trade: the spread of the groups' times is the error of the time") {
    PassGroups groups;
    CHECK(groups.timeError() == 0.0);
    groups.seconds = {1.0, 1.0, 1.0, 1.0};
    CHECK(groups.timeError() == 0.0);
    groups.seconds = {1.0, 3.0, 1.0, 3.0};  // standard deviation 2 / sqrt(3), of a mean of 2
    CHECK(groups.timeError() == doctest::Approx(2.0 / std::sqrt(3.0) / 2.0 / 2.0));
    const GroupedPasses run = passesOf({}, 1000);
    CHECK(run.groups.seconds.size() == run.groups.means.size());
    double sum = 0.0;
    for (const double seconds : run.groups.seconds) sum += seconds;
    CHECK(sum > 0.0);
    CHECK(sum <= run.seconds);
    CHECK(run.waiting() >= 1.0);
    GroupedPasses waited;
    waited.workerSeconds = 3.0;
    waited.processorSeconds = 1.0;
    CHECK(waited.waiting() == 3.0);
}

TEST_CASE("trade: what says that it has no bias is believed until it is proved, others never") {
    TradeCell honest = lawful(*findEstimator("path"), 1.0, 0.0, 100, 1e-3);
    TradeCell blurred = lawful(*findEstimator("photon-map"), 1.0, 0.0, 100, 1e-3);
    for (TradeCell* cell : {&honest, &blurred}) cell->statistics.bias2 = {4e-4, 3e-4};  // 2 %, not sure
    const TradeReport report = tradeReport({honest, blurred}, {1.0, 0.0, true, 1}, 0.05);
    CHECK(report.verdicts[0].law.costOf(0.01, TradeCost::rays));
    CHECK_FALSE(report.verdicts[1].law.costOf(0.01, TradeCost::rays));
    CHECK_FALSE(report.verdicts[1].biased);
    // A smaller depth leaves light out, whatever the estimator says.
    honest.setting.maxDepth = 0;
    CHECK_FALSE(
        tradeReport({honest}, {1.0, 0.0, true, 1}, 0.05).verdicts[0].law.costOf(0.01, TradeCost::rays));
}

TEST_CASE("trade: the error of an exact truth is in the interval of the bias") {
    const EstimatorInfo& radiosity = *findEstimator("radiosity");
    const TradeReport report =
        tradeReport({lawful(radiosity, 1.0, 0.05, 100, 1e-3)}, {1.0, 0.01, true, 1}, 0.05);
    const TradeVerdict& verdict = report.verdicts[0];
    CHECK(verdict.biasLow == doctest::Approx(0.04).epsilon(1e-3));
    CHECK(verdict.biasHigh == doctest::Approx(0.06).epsilon(1e-3));
    CHECK(verdict.careful.bias2 == doctest::Approx(0.06 * 0.06).epsilon(1e-3));
}

TEST_CASE("trade: levels where no pass met what is rare tell nothing of how the error falls") {
    const std::vector<TradeLevel> levels{
        {1, {1.0, 0.0}, 0}, {2, {1.0, 0.0}, 0}, {4, {4.0, 0.8}, 0}, {8, {2.0, 0.4}, 0}, {16, {1.0, 0.2}, 0}};
    const auto exponent = exponentOf(levels);
    REQUIRE(exponent);
    CHECK(exponent->value == doctest::Approx(-0.5));
    // Without noise in any of them all count.
    const auto still = exponentOf({{1, {1.0, 0.0}, 0}, {2, {1.0, 0.0}, 0}, {4, {1.0, 0.0}, 0}});
    REQUIRE(still);
    CHECK(still->value == doctest::Approx(0.0));
}

TEST_CASE("trade: facets that change nothing add no doubt") {
    const EstimatorInfo& path = *findEstimator("path");
    TradeCell plain = lawful(path, 1.0, 0.1, 100, 1e-3);
    plain.statistics.bias2.error = 0.01;  // not sure
    plain.complete = true;
    TradeCell facets = plain, other = plain;
    facets.setting.facets = other.setting.facets = 0.25;
    other.statistics.mean = 1.1;
    const TradeReport report = tradeReport({plain, facets, other}, {1.0, 0.0, true, 1}, 0.05);
    CHECK(report.verdicts[0].toTarget[0].has_value());
    CHECK(report.verdicts[1].sameRunAs == std::size_t{0});
    CHECK(report.verdicts[1].toTarget[0] == report.verdicts[0].toTarget[0]);
    // Without the scene itself among them, two that agree tell the same.
    TradeCell more = facets;
    more.setting.facets = 4.0;
    CHECK(tradeReport({facets, more}, {1.0, 0.0, true, 1}, 0.05).verdicts[0].toTarget[0].has_value());
    CHECK_FALSE(report.verdicts[2].sameRunAs);
    CHECK_FALSE(report.verdicts[2].toTarget[0].has_value());
}

TEST_CASE("trade: what took a moment may have waited for others") {
    const EstimatorInfo &path = *findEstimator("path"), &cast = *findEstimator("cast-ray");
    const auto isNobody = [&](double seconds) {
        const TradeCell fast = lawful(path, 1.0, 0.0, 100, seconds),
                        slow = lawful(cast, 1.1, 0.0, 110, 3.0 * seconds);
        return tradeReport({fast, slow}, {1.0, 0.0, true, 1}, 0.05).verdicts[1].nobody;
    };
    CHECK_FALSE(isNobody(1e-5));
    CHECK(isNobody(1e-2));
}
TEST_CASE("trade: work that is called off leaves what was done") {
    std::uint64_t asked = 0;
    PassBudget budget;
    budget.rays = 1e9;
    const GroupedPasses run =
        runGroups(MadeEstimator({}), kPixels, {}, budget, [&] { return ++asked > 5000; });
    CHECK(run.interrupted);
    CHECK(run.groups.passes() > 1000);
    CHECK(run.groups.passes() <= 5000);
    // Gone on with, again and again, it comes to what an undivided run does.
    budget.rays = 10.0 * 20'000;
    const GroupedPasses whole = runGroups(MadeEstimator({}), kPixels, {}, budget, {});
    GroupedPasses pieces;
    int stops = 0;
    do {
        asked = 0;
        pieces = runGroups(
            MadeEstimator({}), kPixels, {}, budget, [&] { return ++asked > 3000; }, {}, std::move(pieces));
        ++stops;
    } while (pieces.interrupted && stops < 100);
    CHECK(stops > 5);
    CHECK(pieces.groups.each == whole.groups.each);
    CHECK(pieces.groups.means == whole.groups.means);
    CHECK(pieces.counts.rays == whole.counts.rays);
}
