// Does a glossy wall send on what its lobe says, and what does sampling the lobe save?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "core/quadrature.h"
#include "roads.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("roads: the broadest lobe is the same for the recursion and for paths") {
    Scene scene;
    scene.materials = {Glossy{Rgb(0.8), 0.0}};
    scene.segments = {wallOf({-5, 0}, {5, 0}, 0)};
    scene.environment = Rgb(1.0);
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

TEST_CASE(
    "roads: the variance of half-disk sampling over lobe sampling on a glossy wall, as quadrature predicts") {
    // One glossy floor under a lamp of 0.6 m that lies in the mirror direction; the lamp is met by chance.
    Scene scene;
    scene.materials = {Glossy{Rgb(0.8), 60.0}, Diffuse{Rgb(0.0)}};
    scene.segments = {wallOf({-5, 0}, {5, 0}, 0), wallOf({1.3, 1.0}, {0.7, 1.0}, 1, Rgb(1.0))};
    Stage stage = staged("glossy", scene);
    prepare(stage);
    const Vec2 P(0.0, 0.0), looking = glm::normalize(Vec2(1.0, -1.0));
    const SurfacePoint at{
        P, {0.0, 1.0}, {0.0, 1.0}, -looking, 0, true, false, kNoMedium, &stage.scene.materials[0]};
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
