#include "dial.h"

#include <algorithm>

namespace halfdisk {
namespace {

constexpr double kMostWallsTried = 2e5;

}  // namespace

Scene withSlit(const Scene& scene, double gap) {
    Scene copy = scene;
    if (!(gap > 0.0)) return copy;
    Vec2 least(kInfinity), most(-kInfinity);
    for (const Segment& s : scene.segments) {
        least = glm::min(least, glm::min(s.a, s.b));
        most = glm::max(most, glm::max(s.a, s.b));
    }
    const double size = sizeOf(scene);
    const Vec2 middle = scene.segments.empty() ? Vec2(0.0) : (least + most) / 2.0;
    // Slanted: walls along an axis hide what rounding does.
    const Vec2 along = 0.2 * size * Vec2(0.8, 0.6), across = 0.5 * gap * size * Vec2(-0.6, 0.8);
    if (copy.materials.empty()) {
        copy.materials.emplace_back(Diffuse{});
        copy.materialNames.emplace_back("slit");
    }
    const auto add = [&](Vec2 a, Vec2 b, const char* name) {
        Segment wall;
        wall.a = a;
        wall.b = b;
        wall.emission = Rgb(1.0);
        copy.segments.push_back(wall);
        copy.segmentNames.emplace_back(name);
    };
    add(middle - along - across, middle + along - across, "slit.1");
    add(middle + along + across, middle - along + across, "slit.2");
    return copy;
}

ExtremeCounts measureDial(const DialSetting& setting, const Scene& scene, const StopQuestion& stop) {
    const Scene slit = withSlit(scene, setting.gap);
    if (slit.segments.empty()) return {};
    const Placement placing{setting.scale, setting.offset};
    SurveyRays rays;
    rays.seed = setting.seed;
    rays.count =
        std::min(setting.rays,
                 1 + static_cast<std::uint64_t>(kMostWallsTried / static_cast<double>(slit.segments.size())));
    const auto ask = [&](const SurveyRays& some) {
        if (setting.precision == Precision::twice && setting.policy == EpsilonPolicy::ours)
            return surveyOurs(slit, placing, some, stop);
        return surveyNaive(slit, placing, some, setting.precision, setting.policy, setting.fixedEpsilon,
                           stop);
    };
    return ask(rays);
}

}  // namespace halfdisk
