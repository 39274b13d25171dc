#include "dial.h"

#include <algorithm>

namespace halfdisk {
namespace {

constexpr double kMostWallsTried = 2e5;
constexpr std::size_t kKept = 24;  // as many as can be told apart on a screen

}  // namespace

Scene withSlit(const Scene& scene, double gap) {
    Scene copy = scene;
    if (!(gap > 0.0)) return copy;
    const double size = sizeOf(scene);
    const Vec2 middle = boxOf(scene).middle();
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
    const Placement placement{setting.scale, setting.offset};
    SurveyRays rays;
    rays.seed = setting.seed;
    rays.kept = kKept;
    rays.count =
        std::min(setting.rays,
                 1 + static_cast<std::uint64_t>(kMostWallsTried / static_cast<double>(slit.segments.size())));
    if (setting.precision == Precision::twice && setting.policy == EpsilonPolicy::ours)
        return surveyOurs(slit, placement, rays, stop);
    return surveyNaive(slit, placement, rays, setting.precision, setting.policy, setting.fixedEpsilon, stop);
}

}  // namespace halfdisk
