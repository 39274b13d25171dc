// Do the strategies of bidirectional tracing, kept apart in one pass, add up to the estimator's own picture,
// and does each alone find all light that it can carry?
#include <doctest/doctest.h>

#include "agreement.h"
#include "core/estimators/strategy_passes.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

constexpr std::uint32_t kMostVertices = 5;

Stage stageOf(const std::string& name) {
    Stage stage = readStage(name);
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    return stage;
}

const EstimatorInfo& bidirectional() {
    return *findEstimator("bidirectional");
}

StrategyFilm apart(const Stage& stage, const Sensor& sensor, std::uint64_t passes, std::uint32_t maxDepth,
                   std::uint64_t seed = 1) {
    const Problem problem{.index = *stage.index, .sensor = sensor, .maxDepth = maxDepth, .seed = seed};
    return StrategyPasses(problem, initialValues(bidirectional()), StrategyTable(kMostVertices))
        .render(0, passes);
}

/// The sum of all strategies' weighted pictures, but for one.
std::vector<Rgb> sumOf(const StrategyFilm& film, std::optional<std::size_t> without = {}) {
    std::vector<Rgb> sum(film.pixels(), Rgb(0.0));
    for (std::size_t place = 0; place <= film.table.longer(); ++place)
        for (std::size_t i = 0; place != without && i < sum.size(); ++i)
            sum[i] += film.weighted.mean[place * film.pixels() + i];
    return sum;
}

bool same(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (glm::length(a[i] - b[i]) > 1e-10 * glm::length(b[i])) return false;
    return a.size() == b.size();
}

/// What one strategy alone finds, as a film of its own.
Film aloneFilm(const StrategyFilm& film, Strategy strategy) {
    Film alone;
    alone.pixels = film.pictureOf(film.alone, film.table.placeOf(strategy));
    alone.passes = film.whole.passes;
    return alone;
}

bool isBlack(const Film& film) {
    for (const Rgb& mean : film.pixels.mean)
        if (mean != Rgb(0.0)) return false;
    return true;
}

}  // namespace

TEST_CASE("strategies: the table counts those of each length, and all longer ones as one") {
    const StrategyTable table(4);
    CHECK(table.size() == 3 + 4 + 5);
    std::size_t place = 0;
    for (std::uint32_t n = 2; n <= 4; ++n)
        for (std::uint32_t s = 0; s <= n; ++s, ++place) {
            CHECK(table.placeOf({s, n - s}) == place);
            CHECK(table[place] == Strategy{s, n - s});
        }
    CHECK(place == table.longer());
    CHECK(table.placeOf({0, 5}) == table.longer());
    CHECK(table.placeOf({40, 1}) == table.longer());
}

TEST_CASE("strategies: with their weights they add up to the estimator's picture, and none can be left out") {
    for (const char* name : {"mixed", "glass_disk", "closed_room", "sky_only"}) {
        const Stage stage = stageOf(name);
        for (const std::size_t which : {1u, 2u}) {
            INFO(name << ", sensor " << which);
            constexpr std::uint64_t kPasses = 40;
            const Sensor sensor = sensorsOf(stage)[which];
            const StrategyFilm film = apart(stage, sensor, kPasses, 2);
            const Problem problem{.index = *stage.index, .sensor = sensor, .maxDepth = 2};
            const auto estimator = bidirectional().make(problem, initialValues(bidirectional()));
            Film own;
            own.pixels.reset(pixelCount(sensor));
            for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
                Picture picture(pixelCount(sensor));
                estimator->addPass(pass, picture, own.counts);
                own.add(picture);
            }
            CHECK(film.whole.pixels.mean == own.pixels.mean);  // to the bit
            CHECK(film.whole.pixels.squares == own.pixels.squares);
            CHECK(film.whole.counts.rays == own.counts.rays);
            CHECK(same(sumOf(film), own.pixels.mean));
            Rgb means{0.0};
            std::size_t bright = 0;
            for (std::size_t place = 0; place <= film.table.longer(); ++place) {
                means += film.weightedMeans.mean[place];
                if (film.weightedMeans.mean[place] == Rgb(0.0)) continue;
                ++bright;
                CHECK_FALSE(same(sumOf(film, place), own.pixels.mean));
            }
            CHECK(bright >= 3);
            CHECK(glm::length(means - film.wholeMean.mean[0]) < 1e-10 * glm::length(means));
        }
    }
}

TEST_CASE("strategies: each alone is what the estimator makes of this s and t without weights, to the bit") {
    const Stage stage = stageOf("mixed");
    const Sensor sensor = sensorsOf(stage)[1];
    const StrategyFilm film = apart(stage, sensor, 1, 2);
    for (std::size_t place = 0; place < film.table.size(); ++place) {
        const Strategy strategy = film.table[place];
        for (const bool weighs : {false, true}) {
            ParamValues params = initialValues(bidirectional());
            params[0] = strategy.s;
            params[1] = strategy.t;
            params[2] = weighs ? 1.0 : 0.0;
            const Problem problem{.index = *stage.index, .sensor = sensor, .maxDepth = 2};
            Picture picture(pixelCount(sensor));
            Counts counts;
            bidirectional().make(problem, params)->addPass(0, picture, counts);
            INFO("s = " << strategy.s << ", t = " << strategy.t << (weighs ? ", weighted" : ", alone"));
            CHECK(film.pictureOf(weighs ? film.weighted : film.alone, place).mean == picture);
        }
    }
}

TEST_CASE("strategies: batches merge to the same as all passes at once") {
    const Stage stage = stageOf("glossy_wall");
    const Sensor sensor = sensorsOf(stage)[2];
    const Problem problem{.index = *stage.index, .sensor = sensor, .maxDepth = 1};
    const StrategyPasses passes(problem, initialValues(bidirectional()), StrategyTable(kMostVertices));
    StrategyFilm parts = passes.render(0, 7);
    parts.merge(passes.render(7, 13));
    const StrategyFilm all = passes.render(0, 20);
    CHECK(parts.whole.passes == 20);
    CHECK(parts.weighted.samples == 20);
    CHECK(same(parts.weighted.mean, all.weighted.mean));
    CHECK(same(parts.aloneMeans.mean, all.aloneMeans.mean));
    CHECK(parts.aloneMeans[1].standardError().x ==
          doctest::Approx(all.aloneMeans[1].standardError().x).epsilon(1e-9));
}

TEST_CASE("strategies: in a room of matt walls each alone finds all light of its length") {
    const Stage stage = stageOf("closed_room");
    for (const std::size_t which : {1u, 2u}) {
        const Sensor sensor = sensorsOf(stage)[which];
        const std::uint64_t passes = 120'000 / pixelCount(sensor);
        const StrategyFilm film = apart(stage, sensor, passes, 2), other = apart(stage, sensor, passes, 2, 2);
        const std::uint32_t leastT = which == 1 ? 1 : 0;  // an eye is too small to be met
        for (std::uint32_t n = 3; n <= 4; ++n) {
            const Film reference = aloneFilm(other, {1, n - 1});
            REQUIRE_FALSE(isBlack(reference));
            for (std::uint32_t s = 0; s + leastT <= n; ++s) {
                const Film alone = aloneFilm(film, {s, n - s});
                const Agreement agreement = compare(alone, reference, 20);
                INFO("sensor " << which << ", s = " << s << " of " << n << ": " << agreement.where);
                CHECK(agreement.holds());
                // One that was robbed of its weight's rest is found out.
                Film robbed = alone;
                robbed.pixels = film.pictureOf(film.weighted, film.table.placeOf({s, n - s}));
                CHECK_FALSE(compare(robbed, reference, 20).holds());
            }
        }
    }
}

TEST_CASE("strategies: through glass only paths that are never joined at it find the caustic") {
    // Depth 0 on the floor: the lamp straight, or through glass alone.
    const Stage stage = stageOf("glass_disk");
    const Sensor sensor = sensorsOf(stage)[2];
    const StrategyFilm film = apart(stage, sensor, 4000, 0), other = apart(stage, sensor, 4000, 0, 2);
    const std::uint32_t n = 4;  // a lamp, in and out of the glass, the floor
    const Film luck = aloneFilm(other, {0, n}), met = aloneFilm(film, {n, 0});
    REQUIRE_FALSE(isBlack(met));
    REQUIRE_FALSE(isBlack(luck));
    for (std::uint32_t s = 1; s < n; ++s) CHECK(isBlack(aloneFilm(film, {s, n - s})));
    const Agreement agreement = compare(met, luck, 1);
    INFO(agreement.where);
    CHECK(agreement.holds());
    // Both have a share, and together they bring it all.
    const auto share = [&](Strategy strategy) {
        return film.weightedMeans.mean[film.table.placeOf(strategy)].x /
               film.aloneMeans.mean[film.table.placeOf({n, 0})].x;
    };
    CHECK(share({0, n}) > 0.0);
    CHECK(share({n, 0}) + share({0, n}) == doctest::Approx(1.0).epsilon(0.05));
}
