// What can each estimator do at each sensor in a scene?
#include "app/estimator_table.h"

#include "app/estimator_arguments.h"
#include "core/estimate.h"

namespace halfdisk {
namespace {

/// One of each kind, in the order of Sensor; empty where the scene has no place for it.
std::optional<Sensor> exampleOf(std::size_t kind, const SegmentIndex& index) {
    const Scene& scene = index.scene();
    const Eye eye = scene.eye.value_or(Eye{});
    switch (1u << kind) {
        case kProbeBit:
            if (scene.segments.empty()) return std::nullopt;
            return Probe{shadedPointOn(index, 0, 0.5)};
        case kLookBit:
            return Look{eye.position, eye.direction};
        case kEyeBit:
            return EyeStrip{eye};
        case kProfileBit: {
            Profile profile;
            for (std::uint32_t i = 0; i < scene.segments.size(); ++i) profile.segments.push_back(i);
            if (profile.segments.empty()) return std::nullopt;
            return profile;
        }
        default:
            return Field{};
    }
}

std::string refusalAt(const EstimatorInfo& info, std::size_t kind, const SegmentIndex& index) {
    const std::optional<Sensor> sensor = exampleOf(kind, index);
    if (!sensor) return "the scene has no wall";
    constexpr std::uint32_t kLeastDepth = 0;  // what is possible at all, not with what is asked by default
    return refusalOf(info, {index, *sensor, kLeastDepth}, initialValues(info));
}

}  // namespace

Scene sceneOfEverything() {
    Scene scene;
    scene.environment = Rgb(1.0);
    scene.lights = {PointLight{}, DirectionalLight{}};
    scene.materials = {Diffuse{}, Mirror{}, Glossy{}, Dielectric{}};
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        Segment wall{.a = {0.0, i}, .b = {1.0, i}, .material = i};
        if (i == 0) wall.emission = Rgb(1.0);
        scene.segments.push_back(wall);
        scene.segmentNames.push_back("wall" + std::to_string(i));
    }
    return scene;
}

std::vector<EstimatorRow> estimatorRows(const Scene& scene, bool asks) {
    const SegmentIndex index(scene);
    std::vector<EstimatorRow> rows;
    for (const EstimatorInfo* info : estimators()) {
        EstimatorRow& row = rows.emplace_back(EstimatorRow{info, {}});
        for (std::size_t kind = 0; kind < kSensorNames.size(); ++kind) {
            if (!(info->sensors & (1u << kind))) continue;
            row.sensors.push_back({kSensorNames[kind], info->paths(scene, 1u << kind),
                                   asks ? refusalAt(*info, kind, index) : std::string()});
        }
    }
    return rows;
}

}  // namespace halfdisk
