// Is the caustic of a glass disk that of a true circle, in every bin and in all of its power?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "caustic.h"
#include "roads.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

// Over bins first ... last - 1 and those that lie as far on the other side of the axis, which are alike.
// Errors of bins add as those of independent ones, or less.
ZTest overBothSides(const Film& film, std::size_t first, std::size_t last, double exact, double err) {
    const std::size_t bins = film.pixels.size();
    double sum = 0.0, variance = 0.0;
    for (std::size_t k = first; k < last; ++k)
        for (const std::size_t bin : {k, bins - 1 - k}) {
            sum += film.pixels[bin].mean.x;
            variance += std::pow(film.pixels[bin].standardError().x, 2);
        }
    const double count = 2.0 * static_cast<double>(last - first);
    return {sum / count, std::sqrt(variance) / count, exact, err};
}

}  // namespace

TEST_CASE("roads: the caustic of a glass disk, bin by bin, and all of its power") {
    // Means over 0 ... 0.05, 0.1, 0.2, 0.4, 0.8 of light that crosses once (tests/cases/29); there is no
    // other of two events.
    const std::size_t edges[] = {0, 1, 2, 4, 8, 16};
    const double means[] = {13.888058534213913, 0.9259713597883519, 0.5280719157970649, 0.22708532957646488,
                            0.06293917683275745};
    const CausticSetup setup;
    Stage stage = staged("caustic", causticScene(setup, 256, true));
    prepare(stage);
    const std::uint32_t floor = stage.wall("floor");
    Run run{.id = "light",
            .params = {{"paths", 20'000}, {"spread", 1}},
            .maxDepth = 0,
            .maxSpecular = 2,
            .samples = 120 * 100,
            .threads = 2};
    const Film film = measure(stage, Profile{{floor}, setup.bins}, run);
    const std::size_t axis = setup.bins / 2;
    for (std::size_t i = 0; i < 5; ++i) {
        // 256 round facets are off by 0.05 % of the power in all, which is spread over the bins.
        const ZTest test =
            overBothSides(film, axis + edges[i], axis + edges[i + 1], means[i], 6e-4 * means[i] + 2e-4);
        INFO("bin " << i);
        CHECK_MESSAGE(test.within(kSingle), test.text());
        CHECK_MESSAGE(test.standardError < kPrecision * means[i], test.text());
        CHECK_MESSAGE(tellsFivePercent(test), test.text());
    }
    // All that the sun sends into the window [-3, 3] but what the disk turns away: 6 - 2 + p0 + p1 + p3.
    run.maxSpecular = 32;
    run.samples = 50;
    const Film all = measure(stage, Profile{{floor}, 1}, run);
    checkValue(all, 0, (4.0 + 0.04896715294468952 + 1.7479375256665812 + 0.0015172832738565966) / 6.0, 1e-4,
               0.001);
}

TEST_CASE("roads: facets of a glass disk are a trade, and round normals win it") {
    const CausticSetup setup;
    const auto exact = exactCaustic(setup, 4'000'000);
    double power = 0.0;
    for (const double bin : exact) power += bin * 0.05;
    CHECK(power == doctest::Approx(1.7479375256665812).epsilon(1e-6));
    struct Row {
        std::uint32_t facets;
        double flat, round, power;
    };
    // L1 over bins of 0.05, and the power's error, both relative to the power.
    for (const Row& row : {Row{64, 0.34, 0.0042, 0.0008}, Row{256, 0.045, 0.0006, 0.00006},
                           Row{1024, 0.0215, 0.00015, 0.00001}}) {
        const CausticError flat = causticError(exact, facetCaustic(setup, row.facets, false, 400'000));
        const CausticError round = causticError(exact, facetCaustic(setup, row.facets, true, 400'000));
        MESSAGE(fmt::format("{:5} facets: flat {:.2f} %, round {:.3f} %; power {:+.3f} %, {:+.4f} %",
                            row.facets, 100 * flat.distance, 100 * round.distance, 100 * flat.power,
                            100 * round.power));
        CHECK(flat.distance < row.flat);
        CHECK(flat.distance > row.flat / 1.2);
        CHECK(round.distance < row.round);
        CHECK(std::abs(round.power) < row.power);
    }
}
