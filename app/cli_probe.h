// What is asked by `halfdisk probe`, and what is answered?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/requirements_arguments.h"
#include "core/estimate.h"
#include "core/estimators.h"
#include "core/settings.h"

namespace halfdisk {

/// What a probe asks if nothing is said: the lesson's own way, with options of its own.
inline constexpr std::string_view kCastRayId = "cast-ray";

constexpr NumberInfo withInitial(NumberInfo info, std::uint64_t initial) {
    info.initial = initial;
    return info;
}

inline constexpr NumberInfo kProbeSamplesInfo = withInitial(kSamplesInfo, 64);
inline constexpr NumberInfo kRepeatsInfo{"repeat", "R", "independent repeats", 1, 1'000'000'000, 16};
/// A list of values longer than this is refused.
inline constexpr std::uint64_t kMostListed = 10'000;

/// More rays than this are refused unless the user insists: at 10^7 rays a second, a quarter of an hour.
inline constexpr double kMostProbeRays = 1e10;

/// As typed. probeQuestion makes sense of it.
struct ProbeTexts {
    std::string scene, at;
    std::optional<std::string> normal, look;
    std::string estimator{kCastRayId};
    std::vector<std::string> params;
    std::string samples = std::to_string(kProbeSamplesInfo.initial);
    std::string depth = std::to_string(kMaxDepthInfo.initial);
    std::string specular = std::to_string(kMaxSpecularInfo.initial);
    std::optional<std::string> sampler, emitters, repeats;  ///< of castRay
    std::string asPrinted;                                  ///< of castRay; empty: none; "true": all
    std::string seed = std::to_string(kSeedInfo.initial);
    std::optional<std::string> threads;  ///< none: as many as the machine has
    bool anyway = false;
    bool json = false;
    bool list = false;
    PlanTexts plan;
};

struct ProbeQuestion {
    const EstimatorInfo* estimator = findEstimator(kCastRayId);
    Settings settings;  ///< of estimators but castRay: samples is the number of passes
    std::uint64_t repeats = kRepeatsInfo.initial;  ///< of castRay
    ParamValues params;                            ///< where the registry's estimator is asked
    unsigned threads = 1;
    std::optional<Vec2> normal, look;  ///< unit; at most one of them
    bool anyway = false;
    bool list = false;
    PlanRequest plan;  ///< automatic: estimator and params are not known yet, and not castRay's

    bool isCastRay() const { return estimator->id == kCastRayId; }
    /// Not castRay's own estimate of irradiance, but passes of an estimator of the registry.
    bool isByPasses() const { return !isCastRay() || look; }
    std::uint64_t passes() const { return isCastRay() ? repeats : settings.samples; }
};

/// All but the place, which needs the scene. Throws InputError.
ProbeQuestion probeQuestion(const ProbeTexts& texts);

struct ProbePlace {
    ShadedPoint shaded;               ///< what is lit
    Vec2 at{0.0};                     ///< to print: on the wall itself if there is one, m
    std::optional<std::string> wall;  ///< its name
    bool radiance = false;            ///< a matt wall's front was asked for: its radiance is told too
};

/// Reads `X,Y` or `NAME:T`. Throws InputError, also where neither a wall nor a normal is.
ProbePlace probePlace(const SegmentIndex& index, const std::string& at, std::optional<Vec2> normal);

/// A place to look from, anywhere; `shaded.N` is the direction (unit). On a wall: on the side looked to.
ProbePlace lookPlace(const SegmentIndex& index, const std::string& at, Vec2 direction);

/// A mean and how sure it is; nothing is known of that from a single repeat.
struct MeasuredRgb {
    Rgb mean{0.0};
    std::optional<Rgb> standardError;
};

struct ProbeAnswer {
    ProbeQuestion question;
    ProbePlace place;
    Estimate estimate;
    MeasuredRgb irradiance;                ///< W / m
    std::optional<MeasuredRgb> radiance;   ///< W / (m rad), scattered once more
    std::optional<Rgb> variancePerSample;  ///< (W / m)^2; none where samples are not independent
    std::optional<Rgb> exact;              ///< of E, where it is known
    double seconds = 0.0;
    std::vector<Rgb> values;  ///< E of each repeat, if they were asked for
};

/// Throws InputError for more than kMostProbeRays rays, unless the user insists.
void refuseTooManyRays(const SegmentIndex& index, const ProbeQuestion& question);

/// Throws InputError for more than kMostProbeRays rays, unless `anyway`.
ProbeAnswer probe(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place);

/// Whether a wall is matt and flat, so that L = Le + albedo / 2 E holds there.
bool isMatt(const SegmentIndex& index, std::uint32_t segment);

/// Exact E (W/m) by quadrature: for matt scenes of up to 60 walls, depths up to 1, and no defect switched on.
std::optional<Rgb> exactIrradiance(const Scene& scene, const Settings& settings, const ShadedPoint& at);

}  // namespace halfdisk
