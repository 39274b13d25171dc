#include "app/goal_check.h"

#include <algorithm>
#include <cmath>

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

/// 1 less the area between the curve that was drawn and the exact one, as a share of that one's; nothing
/// before nearly all of it is drawn.
std::optional<double> scoreOfDrawing(const AppState& state) {
    const std::vector<IntegrandPoint>& exact = state.answer->integrand;
    if (!isDrawn(state) || exact.empty()) return std::nullopt;
    double off = 0.0, area = 0.0;
    for (const IntegrandPoint& point : exact) {
        const double share = std::clamp(point.theta / kPi, 0.0, 0.999999);
        const float drawn = state.drawn[static_cast<std::size_t>(share * kDrawnBins)];
        const double truth = gray(point.radiance);
        off += std::abs(std::max(0.0f, drawn) - truth);
        area += truth;
    }
    return area > 0.0 ? std::max(0.0, 1.0 - off / area) : (off > 0.0 ? 0.0 : 1.0);
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
        case GoalQuantity::line:
            if (state.chosenLine == 0) return std::nullopt;
            return std::count(goal.lines.begin(), goal.lines.end(), state.chosenLine) > 0 ? 1.0 : 0.0;
        case GoalQuantity::drawn:
            return scoreOfDrawing(state);
        case GoalQuantity::rays:
            return static_cast<double>(answer.rays);
    }
    return std::nullopt;
}

bool isDrawn(const AppState& state) {
    constexpr double kNearlyAll = 0.95;
    const auto drawn =
        std::count_if(state.drawn.begin(), state.drawn.end(), [](float v) { return v >= 0.0f; });
    return !state.drawing && static_cast<double>(drawn) >= kNearlyAll * kDrawnBins;
}

bool asksForCurve(const AppState& state) {
    const Step* step = state.currentStep();
    return step && step->goal && step->goal->quantity == GoalQuantity::drawn;
}

bool isReached(const Goal& goal, double value) {
    return goal.relation == Relation::atMost ? value <= goal.number : value >= goal.number;
}

}  // namespace halfdisk
