#include "estimator.h"

#include <cmath>
#include <cstdio>

namespace halfdisk {
namespace {

std::string textOf(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string faultOfParam(const ParamInfo& info, double value) {
    const double most = info.choices.empty() ? info.most : static_cast<double>(info.choices.size() - 1);
    const bool whole = info.whole || !info.choices.empty();
    if (value >= info.least && value <= most && (!whole || value == std::floor(value))) return {};
    return std::string(info.name) + " is " + textOf(value) + ", expected a " +
           (whole ? "whole number" : "number") + " from " + textOf(info.least) + " to " + textOf(most);
}

std::string sensorsOf(const EstimatorInfo& info) {
    std::string names;
    for (std::size_t i = 0; i < kSensorNames.size(); ++i)
        if (info.sensors & (1u << i)) names += (names.empty() ? "" : ", ") + std::string(kSensorNames[i]);
    return names;
}

}  // namespace

ParamValues initialValues(const EstimatorInfo& info) {
    ParamValues values;
    for (const ParamInfo& param : info.params) values.push_back(param.initial);
    return values;
}

std::string refusalOf(const EstimatorInfo& info, const Problem& problem, const ParamValues& params) {
    if (!(info.sensors & bitOf(problem.sensor)))
        return std::string(info.id) + " does not serve the sensor " +
               std::string(kSensorNames[problem.sensor.index()]) + ", only: " + sensorsOf(info);
    if (std::string fault = faultOf(problem.sensor, problem.index); !fault.empty()) return fault;
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (std::string fault = faultOfParam(info.params[i], params[i]); !fault.empty()) return fault;
    return info.refusal ? info.refusal(problem, params) : std::string();
}

SceneTraits traitsOf(const Scene& scene) {
    SceneTraits traits;
    traits.delta = !scene.lights.empty();
    traits.area = scene.environment.radiance != Rgb(0.0);
    for (const Segment& wall : scene.segments) {
        traits.area = traits.area || isEmitter(wall);
        const Material& material = scene.materials[wall.material];
        const auto* mix = std::get_if<Mix>(&material);
        const bool mirrorPart = mix && std::holds_alternative<Mirror>(mix->specular);
        traits.specular = traits.specular || isSpecular(material) || mirrorPart;
        traits.glass = traits.glass || std::holds_alternative<Dielectric>(material);
        traits.scattering = traits.scattering || !isSpecular(material);
        traits.diffuseOnly =
            traits.diffuseOnly && std::holds_alternative<Diffuse>(material) && !isSmooth(wall);
    }
    return traits;
}

std::string allPaths(const Scene& scene) {
    const SceneTraits traits = traitsOf(scene);
    if (!traits.delta && !traits.area) return "none: no light";
    if (traits.specular && traits.scattering) return "L(S|D)*E";
    return traits.specular ? "LS*E" : traits.scattering ? "LD*E" : "LE";
}

}  // namespace halfdisk
