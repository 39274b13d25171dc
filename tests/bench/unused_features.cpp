// How many instructions do paths take in a matt room? Run by unused_features.sh, once as it is and once with
// glass, mirrors, lobes, round walls and the environment taken out of the program.
#include <cstdio>
#include <cstdlib>

#include "core/estimators/all.h"

using namespace halfdisk;

namespace {

void addWall(Scene& scene, Vec2 a, Vec2 b, Rgb emission = Rgb(0.0)) {
    Segment wall;
    wall.a = a;
    wall.b = b;
    wall.emission = emission;
    scene.segments.push_back(wall);
    scene.segmentNames.emplace_back("wall");
}

/// The room of lesson 18: a lamp under the ceiling, and a shelf.
Scene mattRoom() {
    Scene scene;
    scene.materials.push_back(Diffuse{Rgb(0.7)});
    scene.materialNames.emplace_back("white");
    addWall(scene, {1.3, 2.0}, {0.7, 2.0}, Rgb(3.0));
    const Vec2 corners[] = {{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}, {0.0, 2.0}};
    for (int k = 0; k < 4; ++k) addWall(scene, corners[k], corners[(k + 1) % 4]);
    const Vec2 shelf[] = {{1.7, 1.0}, {1.7, 1.1}, {2.5, 1.1}, {2.5, 1.0}};
    for (int k = 0; k < 4; ++k) addWall(scene, shelf[k], shelf[(k + 1) % 4]);
    return scene;
}

}  // namespace

int main(int count, char** arguments) {
    const long passes = count > 1 ? std::atol(arguments[1]) : 100;
    const Scene scene = mattRoom();
    const SegmentIndex index(scene, IndexMethod::bruteForce);
    const Sensor sensor = Profile{{1}, 32};
    const Problem problem{.index = index, .sensor = sensor, .maxDepth = 4};
    const ParamValues params = initialValues(kPathEstimator);
    const auto estimator = kPathEstimator.make(problem, params);
    Picture picture(32);
    Counts counts;
    for (long pass = 0; pass < passes; ++pass)
        estimator->addPass(static_cast<std::uint64_t>(pass), picture, counts);
    Rgb sum{0.0};
    for (const Rgb& value : picture) sum += value;
    std::printf("%llu rays, mean %.17g\n", static_cast<unsigned long long>(counts.rays),
                sum.x / (32.0 * static_cast<double>(passes)));
    return 0;
}
