// What is told of the estimators, in general and in a scene? Their registry's rows, made readable.
#pragma once

#include <string>
#include <vector>

#include "app/cli_output.h"
#include "core/estimators.h"

namespace halfdisk {

/// What one estimator can do at one sensor.
struct SensorAbility {
    std::string_view sensor;
    std::string paths;    ///< which it carries
    std::string refusal;  ///< why it cannot work in the scene; empty: it can
};

struct EstimatorRow {
    const EstimatorInfo* info;
    std::vector<SensorAbility> sensors;  ///< those that it serves
};

/// Every kind of light and wall, so that all differences between estimators show.
Scene sceneOfEverything();

/// `asks`: whether each estimator is asked if it would work in the scene (at a wall's middle, from its eye,
/// along all walls, around all).
std::vector<EstimatorRow> estimatorRows(const Scene& scene, bool asks);

Json rowsJson(const std::vector<EstimatorRow>& rows);

/// At most 100 columns wide. `file` is the scene's, empty if it is that of everything.
std::string rowsText(const std::vector<EstimatorRow>& rows, const std::string& file);

}  // namespace halfdisk
