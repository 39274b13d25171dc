// Do photons and virtual lights find what comes straight from lamps and sky once, and with less noise than by
// one light that is drawn?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "agreement.h"
#include "core/estimators/all.h"
#include "core/exact.h"
#include "rooms.h"
#include "run_estimator.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

struct Way {
    const EstimatorInfo* info;
    std::vector<std::pair<std::string_view, double>> params;
    double gain;  // the variance of one drawn light over its own, at least
};

std::vector<Way> ways() {
    return {{&kPhotonMapEstimator, {{"photons", 50}, {"gather", 8}}, 2.5},
            {&kPhotonMapEstimator, {{"photons", 50}, {"gather", 0}}, 1.5},
            {&kVirtualLightsEstimator, {{"paths", 4}}, 1.5}};
}

}  // namespace

TEST_CASE(
    "direct light: found once from lamps, sky and lights without size, at a point and as a wall sends it") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    const ShadedPoint floor = shadedPointOn(index, 0, 0.3);
    const Vec2 eye = floor.P + Vec2(0.1, 0.2);
    const Rgb exact = directIrradiance(visibility, floor);
    const Rgb half = std::get<Diffuse>(scene.materials[0]).albedo / 2.0;
    for (const Way& way : ways()) {
        const Ask ask{way.params, 0, 40'000};
        const Film probe = runEstimator(*way.info, index, Probe{floor}, ask);
        const Film look = runEstimator(*way.info, index, Look{eye, glm::normalize(floor.P - eye)}, ask);
        for (int c = 0; c < 3; ++c) {
            INFO(way.info->id);
            for (const ZTest& test : {zTest(probe.pixels[0], exact[c], 1e-9, c),
                                      zTest(look.pixels[0], half[c] * exact[c], 1e-9, c)}) {
                CHECK_MESSAGE(test.within(kSingle), test.text());
                CHECK_MESSAGE(test.standardError < 0.01 * test.exact, test.text());
            }
        }
    }
}

TEST_CASE("direct light: less noisy than one drawn light, under a sky and on a glossy wall") {
    for (const char* name : {"sky_only", "glossy_wall"}) {
        Stage stage = readStage(name);
        stage.index = std::make_unique<SegmentIndex>(stage.scene);
        const Sensor sensors[] = {Probe{shadedPointOn(*stage.index, 0, 0.37)},
                                  EyeStrip{stage.scene.eye.value(), 6}};
        for (const Sensor& sensor : sensors) {
            const auto variance = [&](const EstimatorInfo& info, const Ask& ask) {
                const Film film = runEstimator(info, *stage.index, sensor, ask);
                double sum = 0.0;
                for (const Statistics& pixel : film.pixels) sum += pixel.variance().x;
                return sum;
            };
            const double drawn = variance(kPathEstimator, {{{"emitters", 0}}, 0, 20'000});
            for (const Way& way : ways()) {
                const double gain = drawn / variance(*way.info, {way.params, 0, 5'000});
                MESSAGE(fmt::format("{} {} {}: variance less by {:.2f}", name, kSensorNames[sensor.index()],
                                    way.info->id, gain));
                CHECK(gain > way.gain);
            }
        }
    }
}
