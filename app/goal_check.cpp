#include "app/goal_check.h"

#include <algorithm>

namespace halfdisk {
namespace {

/// Of the profile's bin at P.
std::optional<double> binAtP(const AppState& state) {
    const auto& picture = state.answer->pictures.profile;
    if (!picture || picture->film.passes == 0) return std::nullopt;
    const std::vector<Rgb>& bins = picture->film.pixels.mean;
    const double place = std::clamp(state.at.t, 0.0, 0.999999) * static_cast<double>(bins.size());
    return gray(bins[static_cast<std::size_t>(place)]);
}

/// Typical error of a run of N samples, W/m: what its own samples say if they are many, else how whole runs
/// differ.
std::optional<double> errorOfRun(const LightAnswer& answer) {
    constexpr std::uint32_t kManySamples = 256;
    constexpr std::uint64_t kLeastRuns = 8;
    if (answer.standardError && answer.asked.settings.samples >= kManySamples)
        return gray(*answer.standardError);
    if (answer.runs.count < kLeastRuns) return std::nullopt;
    return std::sqrt(gray(answer.runs.variance()));
}

std::optional<double> irradianceOf(const LightAnswer& answer) {
    if (answer.exact) return gray(*answer.exact);
    if (answer.runs.count == 0) return std::nullopt;
    return gray(answer.runs.mean);
}

}  // namespace

std::optional<double> valueOf(const Goal& goal, const AppState& state) {
    // An answer to an older question says nothing about what was just changed.
    if (!state.answer || state.answer->asked.id != state.questionId) return std::nullopt;
    const LightAnswer& answer = *state.answer;
    switch (goal.quantity) {
        case GoalQuantity::irradiance:
            return irradianceOf(answer);
        case GoalQuantity::profile:
            return binAtP(state);
        case GoalQuantity::standardError:
            return errorOfRun(answer);
        case GoalQuantity::relativeError: {
            const auto error = errorOfRun(answer), mean = irradianceOf(answer);
            if (!error || !mean || !(*mean > 0.0)) return std::nullopt;
            return *error / *mean;
        }
        case GoalQuantity::rays:
            return static_cast<double>(answer.rays);
    }
    return std::nullopt;
}

bool isReached(const Goal& goal, double value) {
    return goal.relation == Relation::atMost ? value <= goal.number : value >= goal.number;
}

}  // namespace halfdisk
