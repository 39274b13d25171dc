#include "roads.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace halfdisk::test {

Stage staged(const std::string& name, Scene scene) {
    Stage stage;
    stage.name = name;
    stage.scene = std::move(scene);
    for (std::size_t i = stage.scene.segmentNames.size(); i < stage.scene.segments.size(); ++i)
        stage.scene.segmentNames.push_back("wall" + std::to_string(i));
    for (std::size_t i = stage.scene.materialNames.size(); i < stage.scene.materials.size(); ++i)
        stage.scene.materialNames.push_back("material" + std::to_string(i));
    return stage;
}

void prepare(Stage& stage) {
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
}

Film measureWell(const Stage& stage, const Sensor& sensor, Run run) {
    constexpr double kAim = 0.9 * kPrecision;
    Run pilot = run;
    pilot.seed += 1000;
    const Statistics small = measure(stage, sensor, pilot).pixels[0];
    double error = 0.0;
    for (int c = 0; c < 3; ++c) error = std::max(error, small.standardError()[c] / small.mean[c] / kAim);
    run.samples =
        static_cast<std::uint64_t>(static_cast<double>(run.samples) * std::clamp(error * error, 0.05, 300.0));
    return measure(stage, sensor, run);
}

Film measureAgain(const Stage& stage, const Sensor& sensor, Run run, const Film& first) {
    run.seed += 2000;
    run.samples = 4 * first.passes * first.pixels.size();
    return measure(stage, sensor, run);
}

void checkValue(const Film& film, std::size_t pixel, double exact, double err, double precision) {
    const ZTest test = zTest(film.pixels[pixel], exact, err);
    CHECK_MESSAGE(test.within(kSingle), test.text());
    CHECK_MESSAGE(test.standardError <= precision * exact, test.text());
    CHECK_MESSAGE(tellsFivePercent(test), test.text());
}

}  // namespace halfdisk::test
