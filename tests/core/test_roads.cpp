// Does light go where it should over mirrors and through glass? Exact answers, what is lost for good, and the
// lesson's claims.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "agreement.h"
#include "cases.h"
#include "caustic.h"
#include "core/quadrature.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Stage staged(const std::string& name, Scene scene) {
    Stage stage;
    stage.name = name;
    stage.scene = std::move(scene);
    return stage;
}
void prepare(Stage& stage) {
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
}

Segment wall(Vec2 a, Vec2 b, std::uint32_t material, Rgb emission = Rgb(0.0)) {
    Segment segment;
    segment.a = a;
    segment.b = b;
    segment.material = material;
    segment.emission = emission;
    return segment;
}

void nameAll(Scene& scene) {
    for (std::size_t i = scene.segmentNames.size(); i < scene.segments.size(); ++i)
        scene.segmentNames.push_back("wall" + std::to_string(i));
    for (std::size_t i = scene.materialNames.size(); i < scene.materials.size(); ++i)
        scene.materialNames.push_back("material" + std::to_string(i));
}

/// Relative standard error of the first channel, and the distance to the truth.
void checkValue(const Film& film, std::size_t pixel, double exact, double err, double precision,
                double scale = 1.0) {
    const Statistics& value = film.pixels[pixel];
    const double mean = value.mean.x * scale, error = value.standardError().x * scale;
    INFO(mean << " +- " << error << ", exact " << exact);
    CHECK(error <= precision * exact);
    CHECK(std::abs(mean - exact) <= kSingle * error + err);
    // Five percent off is told.
    CHECK(std::abs(1.05 * mean - exact) > kSingle * 1.05 * error + err);
}

/// A small run tells how many samples pixel 0 needs for a relative standard error of 0.5 %; then the run
/// itself.
Film measureWell(const Stage& stage, const Sensor& sensor, Run run) {
    constexpr double kPrecision = 0.0045;
    Run pilot = run;
    pilot.seed += 1000;
    const Statistics small = measure(stage, sensor, pilot).pixels[0];
    double error = 0.0;
    for (int c = 0; c < 3; ++c)
        error = std::max(error, small.standardError()[c] / small.mean[c] / kPrecision);
    run.samples =
        static_cast<std::uint64_t>(static_cast<double>(run.samples) * std::clamp(error * error, 0.05, 300.0));
    return measure(stage, sensor, run);
}

double meanOf(const Film& film, std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) sum += film.pixels[i].mean.x;
    return sum / static_cast<double>(last - first);
}

}  // namespace

TEST_CASE("roads: every case's deepest exact answers, and those without limit") {
    // 07, a circle of 10 000 walls, takes minutes of brute force.
    for (const std::string name : {"01_segment_light", "03_occluded_light", "05_white_furnace",
                                   "09_cornell_rgb", "14_square_albedo_0.99", "16_vgroove_60", "20b_grazing",
                                   "22_environment_box", "24_cornell_mirror_wall"}) {
        const Case exact = readCase(name);
        Stage stage = staged(exact.name, exact.scene);
        prepare(stage);
        for (const Answer& answer : exact.answers) {
            const ShadedPoint point = pointOf(*stage.index, answer);
            const Sensor probe = Probe{point};
            const auto check = [&](const char* id, std::uint32_t depth, const Rgb& value) {
                const EstimatorInfo* info = findEstimator(id);
                if (info->paths(stage.scene, bitOf(probe)) != allPaths(stage.scene)) return;
                const Film film =
                    measureWell(stage, probe, {.id = id, .maxDepth = depth, .samples = 20'000, .threads = 2});
                for (int c = 0; c < 3; ++c) {
                    const bool radiance = answer.query == "radiance";
                    const double scale = radiance ? point.albedo[c] / 2.0 : 1.0;
                    const double emitted = radiance ? stage.scene.segments[point.segment].emission[c] : 0.0;
                    const double mean = emitted + film.pixels[0].mean[c] * scale,
                                 error = film.pixels[0].standardError()[c] * scale;
                    INFO(name << " " << id << " " << answer.wall << " " << answer.t << " depth " << depth
                              << ": " << mean << " +- " << error << ", exact " << value[c]);
                    CHECK(std::abs(mean - value[c]) <= kSweep * error + answer.err);
                    CHECK(error <= 0.006 * value[c]);
                }
            };
            const std::size_t last = answer.depth.size() - 1;
            if (const auto setting = depthSetting(answer, last))
                for (const char* id : {"path", "light", "bidirectional"})
                    check(id, *setting, answer.depth[last]);
            // In a square of albedo 0.99 one part in 20 000 is missing after 1000 scatterings: far below the
            // noise.
            if (answer.unlimited)
                for (const char* id : {"path", "light"}) check(id, 1000, *answer.unlimited);
        }
    }
}

TEST_CASE("roads: radiance seen in a mirror") {
    Stage stage = staged("mirror", readCase("24_cornell_mirror_wall").scene);
    prepare(stage);
    // 0.8 times the radiance of the left wall at y = 0.85, at depths 1, 2, 3 (tests/cases/24).
    const double exact[] = {0.04837078484157635, 0.05000597531759352, 0.06007435853999537};
    const Sensor look = Look{{1.4, 1.5}, {0.9701425001453319, -0.24253562503633297}};
    for (std::uint32_t depth = 0; depth < 3; ++depth)
        for (const char* id : {"path", "cast-ray", "bidirectional"}) {
            INFO(id << " depth " << depth + 1);
            Run run{.id = id, .maxDepth = depth, .samples = 20'000, .threads = 2};
            if (run.id == "cast-ray") run.params = {{"samples", 3}};
            checkValue(measureWell(stage, look, run), 0, exact[depth], 1e-6, 0.005);
        }
}

TEST_CASE("roads: the sun through a slab") {
    const double degrees[] = {0.0, 30.0, 60.0};
    const double refractionOnly[] = {0.9216, 0.79559924498325, 0.4147904220680195};
    const double total[] = {0.923076923076923, 0.7969733293886283, 0.41811623135508424};
    for (int i = 0; i < 3; ++i) {
        Scene scene;
        scene.materials = {Dielectric{1.5, Rgb(0.0)}, Diffuse{Rgb(0.0)}};
        scene.segments = {wall({-50, 1}, {-50, 1.5}, 0), wall({-50, 1.5}, {50, 1.5}, 0),
                          wall({50, 1.5}, {50, 1}, 0), wall({50, 1}, {-50, 1}, 0),
                          wall({-60, 0}, {60, 0}, 1)};
        const double angle = degrees[i] * kPi / 180.0;
        scene.lights.push_back(DirectionalLight{{std::sin(angle), -std::cos(angle)}, Rgb(1.0)});
        nameAll(scene);
        Stage stage = staged("slab", scene);
        prepare(stage);
        for (const char* id : {"light", "bidirectional"}) {
            INFO(id << " at " << degrees[i] << " degrees");
            Run run{.id = id, .maxDepth = 0, .samples = 1'200'000, .threads = 2};
            checkValue(measure(stage, Profile{{4}, 12}, run), 6, total[i], 1e-12, 0.006);
            run.maxSpecular = 2;
            checkValue(measure(stage, Profile{{4}, 12}, run), 6, refractionOnly[i], 1e-12, 0.006);
        }
    }
}

TEST_CASE("roads: tinted glass, straight through a slab") {
    Scene scene;
    scene.materials = {Dielectric{1.5, Rgb(0.3, 1.0, 4.0)}};
    scene.segments = {wall({-9, 0}, {-9, 0.5}, 0), wall({-9, 0.5}, {9, 0.5}, 0), wall({9, 0.5}, {9, 0}, 0),
                      wall({9, 0}, {-9, 0}, 0)};
    scene.environment.radiance = Rgb(1.0);
    // Bright below only, so that what the slab reflects does not count.
    scene.environment.strip = {Rgb(0.0), Rgb(0.0), Rgb(1.0), Rgb(1.0)};
    nameAll(scene);
    Stage stage = staged("tinted", scene);
    prepare(stage);
    const double F = 0.04;
    for (const char* id : {"path", "cast-ray", "bidirectional"}) {
        const Film film = measure(stage, Look{{0.1, 2.0}, {0.0, -1.0}},
                                  {.id = id, .maxDepth = 0, .samples = 200'000, .threads = 2});
        for (int c = 0; c < 3; ++c) {
            // All orders of inner reflection: (1 - F)^2 k / (1 - F^2 k^2).
            const double k = std::exp(-0.5 * Rgb(0.3, 1.0, 4.0)[c]);
            INFO(id << " channel " << c);
            CHECK(zTest(film.pixels[0], (1 - F) * (1 - F) * k / (1 - F * F * k * k), 1e-9, c).within(kSweep));
        }
    }
}

TEST_CASE("roads: a point in absorbing glass loses light on the way to it, by every estimator") {
    // A disk of index 1 and absorption 1/m about the point: what arrives has run one metre in it.
    CausticSetup setup;
    setup.ior = 1.0;
    Scene scene = causticScene(setup, 256, true);
    scene.segments.pop_back();
    scene.segmentNames.pop_back();
    scene.lights.clear();
    scene.materials[0] = Dielectric{1.0, Rgb(1.0)};
    scene.environment = Rgb(1.0);
    Stage sky = staged("tinted disk", scene);
    scene.environment = Rgb(0.0);
    scene.lights = {PointLight{{0.5, setup.height}, Rgb(1.0)}};
    Stage bulb = staged("bulb in the disk", scene);
    prepare(sky);
    prepare(bulb);
    const Vec2 middle(0.0, setup.height);
    const auto probed = [&](const Stage& stage, Vec2 normal) {
        return Probe{*shadedPointAt(*stage.index, middle, normal)};
    };
    const EstimateOptions options{.repeats = 400};
    for (const char* id : {"cast-ray", "path"}) {
        INFO(id);
        // 256 facets are nearer than the circle by one part in 20 000 on average.
        CHECK(
            zTest(measure(sky, probed(sky, {0, 1}), {.id = id, .maxDepth = 0, .samples = 100'000}).pixels[0],
                  2.0 / std::exp(1.0), 1e-4)
                .within(kSingle));
        CHECK(
            measure(bulb, probed(bulb, {1, 0}), {.id = id, .maxDepth = 0, .samples = 100}).pixels[0].mean.x ==
            doctest::Approx(2.0 * std::exp(-0.5)));
    }
    Settings settings;
    settings.maxDepth = 0;
    const Estimate probe = estimateIrradiance(*sky.index, probed(sky, {0, 1}).at, settings, options);
    CHECK(zTest(probe.repeats, 2.0 / std::exp(1.0), 1e-4).within(kSingle));
}

TEST_CASE("roads: the broadest lobe is the same for the recursion and for paths") {
    Scene scene;
    scene.materials = {Glossy{Rgb(0.8), 0.0}};
    scene.segments = {wall({-5, 0}, {5, 0}, 0)};
    scene.environment = Rgb(1.0);
    nameAll(scene);
    Stage stage = staged("broad", scene);
    prepare(stage);
    // Seen at 60 degrees the lobe is cut at 90 degrees from the mirror direction: f = 0.4 over -30 ... 90
    // degrees.
    const double exact = 0.4 * (1.0 + std::sin(kPi / 6));
    const Sensor look = Look{{-std::sqrt(3.0) / 2, 0.5}, {std::sqrt(3.0) / 2, -0.5}};
    for (const double sampler : {0.0, 1.0, 3.0})
        CHECK(
            zTest(measure(
                      stage, look,
                      {.id = "cast-ray", .params = {{"sampler", sampler}}, .maxDepth = 0, .samples = 40'000})
                      .pixels[0],
                  exact)
                .within(kSingle));
    CHECK(zTest(measure(stage, look, {.id = "path", .maxDepth = 0, .samples = 100'000}).pixels[0], exact)
              .within(kSingle));
}

TEST_CASE("roads: a glass disk under an even sky shows the sky") {
    CausticSetup setup;
    Scene scene = causticScene(setup, 256, true);
    scene.segments.pop_back();
    scene.segmentNames.pop_back();
    scene.lights.clear();
    scene.environment = Rgb(1.0);
    Stage stage = staged("furnace", scene);
    prepare(stage);
    const Vec2 middle(0.0, setup.height);
    for (const char* id : {"path", "cast-ray", "bidirectional"}) {
        INFO(id);
        const Film outside =
            measure(stage, Look{middle + Vec2(0.6, 5.0), {0.0, -1.0}}, {.id = id, .samples = 20'000});
        CHECK(outside.pixels[0].mean.x == doctest::Approx(1.0).epsilon(1e-12));
        const Sensor within = Look{middle + Vec2(0.1, 0.2), {0.6, 0.8}};
        // Within, radiance is larger by the index.
        CHECK(measure(stage, within, {.id = id, .samples = 20'000}).pixels[0].mean.x ==
              doctest::Approx(1.5).epsilon(1e-12));
        checkValue(measure(stage, within, {.id = id, .maxSpecular = 1, .samples = 100'000}), 0,
                   1.4399996815460228, 1e-4, 0.005);
    }
    // Reflected and once refracted light alone; the facets' error is below 1e-4 at 256.
    checkValue(measure(stage, Look{middle + Vec2(0.6, 5.0), {0.0, -1.0}},
                       {.id = "path", .maxSpecular = 2, .samples = 200'000}),
               0, 0.04389473600344824 + 0.9141372758419158, 1e-4, 0.005);
}

TEST_CASE("roads: the caustic of a glass disk, bin by bin, and all of its power") {
    // Means over 0 ... 0.05, 0.1, 0.2, 0.4, 0.8 of light that crosses once (tests/cases/29); there is no
    // other of two events.
    const double edges[] = {0, 1, 2, 4, 8, 16},
                 means[] = {13.888058534213913, 0.9259713597883519, 0.5280719157970649, 0.22708532957646488,
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
    for (int i = 0; i < 5; ++i) {
        // Both sides of the axis are alike; errors of bins add as those of independent ones, or less.
        const auto first = static_cast<std::size_t>(60 + edges[i]),
                   last = static_cast<std::size_t>(60 + edges[i + 1]);
        const auto mirrorFirst = static_cast<std::size_t>(60 - edges[i + 1]),
                   mirrorLast = static_cast<std::size_t>(60 - edges[i]);
        const double mean = (meanOf(film, first, last) + meanOf(film, mirrorFirst, mirrorLast)) / 2.0;
        double variance = 0.0;
        for (std::size_t k = first; k < last; ++k)
            variance += std::pow(film.pixels[k].standardError().x, 2) +
                        std::pow(film.pixels[119 - k].standardError().x, 2);
        const double error = std::sqrt(variance) / (2.0 * static_cast<double>(last - first));
        INFO("bin " << i << ": " << mean << " +- " << error << ", exact " << means[i]);
        CHECK(error < 0.005 * means[i]);
        // 256 round facets are off by 0.05 % of the power in all, which is spread over the bins.
        CHECK(std::abs(mean - means[i]) < kSweep * error + 6e-4 * means[i] + 2e-4);
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

TEST_CASE("roads: what can't be found is exactly zero") {
    SUBCASE("castRay and path tracing find no caustic of a light without size") {
        Stage stage = staged("caustic", causticScene({}, 64, true));
        prepare(stage);
        // Below the disk only light through it arrives: no shadow ray gets there, and the sun can't be met.
        const Sensor below = Probe{shadedPointOn(*stage.index, stage.wall("floor"), 0.5)};
        for (const char* id : {"cast-ray", "path"})
            for (const double emitters : {0.0, 1.0, 2.0}) {
                const Film film =
                    measure(stage, below, {.id = id, .params = {{"emitters", emitters}}, .samples = 20'000});
                CHECK(film.pixels[0].mean == Rgb(0.0));
                CHECK(film.pixels[0].squares == Rgb(0.0));
            }
    }
    SUBCASE("light tracing does not see through the pinhole what a mirror shows") {
        Stage stage = readStage("mirror_room");
        prepare(stage);
        // An eye close to the mirror that sees nothing else.
        const Sensor eye = EyeStrip{{{1.95, 1.0}, {1.0, 0.0}, kPi / 3}, 4};
        const Film film = measure(stage, eye, {.id = "light", .samples = 40'000});
        const Film truth = measure(stage, eye, {.id = "path", .samples = 40'000});
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(film.pixels[i].mean == Rgb(0.0));
            CHECK(truth.pixels[i].mean.x > 10.0 * truth.pixels[i].standardError().x);
        }
    }
    SUBCASE("nor does a probe below glass get its direct light by light tracing") {
        Stage stage = staged("caustic", causticScene({}, 64, true));
        prepare(stage);
        const Film film = measure(stage, Probe{shadedPointOn(*stage.index, stage.wall("floor"), 0.5)},
                                  {.id = "light", .maxDepth = 3, .samples = 20'000});
        CHECK(film.pixels[0].mean == Rgb(0.0));
    }
}

TEST_CASE(
    "roads: the variance of half-disk sampling over lobe sampling on a glossy wall, as quadrature predicts") {
    // One glossy floor under a lamp of 0.6 m that lies in the mirror direction; the lamp is met by chance.
    Scene scene;
    scene.materials = {Glossy{Rgb(0.8), 60.0}, Diffuse{Rgb(0.0)}};
    scene.segments = {wall({-5, 0}, {5, 0}, 0), wall({1.3, 1.0}, {0.7, 1.0}, 1, Rgb(1.0))};
    nameAll(scene);
    Stage stage = staged("glossy", scene);
    prepare(stage);
    const Vec2 P(0.0, 0.0), looking = glm::normalize(Vec2(1.0, -1.0));
    const SurfacePoint at{P, {0.0, 1.0}, {0.0, 1.0}, -looking, 0, true, kNoMedium, &stage.scene.materials[0]};
    // The lamp is seen from atan(0.7) to atan(1.3) off the normal. A sample is f cos / pdf there and 0
    // elsewhere.
    const auto moments = [&](bool lobe) {
        const auto f = [&](double angle) {
            const Vec2 to(std::sin(angle), std::cos(angle));
            const double value = evalSurface(at, to, at.from).x * to.y;
            return Integrals<2>{value, value * value / (lobe ? pdfSurface(at, at.from, to) : 1.0 / kPi)};
        };
        const auto sum = integrate<2>(f, std::atan(0.7), std::atan(1.3), {1e-12, 1e-12}, 20);
        return std::pair(sum[0], sum[1] - sum[0] * sum[0]);
    };
    const auto [mean, uniformVariance] = moments(false);
    const double lobeVariance = moments(true).second;
    Film films[2];
    for (int i = 0; i < 2; ++i) {
        const double sampler = i == 0 ? 0 : 3;  // uniform, lobe
        films[i] = measure(stage, Look{P - looking, looking},
                           {.id = "cast-ray",
                            .params = {{"samples", 1}, {"sampler", sampler}, {"emitters", 1}},
                            .maxDepth = 0,
                            .samples = 400'000,
                            .threads = 2});
        CHECK(zTest(films[i].pixels[0], mean, 1e-9).within(kSingle));
    }
    const double predicted = uniformVariance / lobeVariance;
    const double measured = films[0].pixels[0].variance().x / films[1].pixels[0].variance().x;
    MESSAGE(fmt::format("variance of half-disk over lobe sampling: predicted {:.3f}, measured {:.3f}",
                        predicted, measured));
    CHECK(predicted > 5.0);
    // Each variance of n samples is known to sqrt((kurtosis - 1) / n): below one percent here.
    CHECK(measured == doctest::Approx(predicted).epsilon(0.03));
}
