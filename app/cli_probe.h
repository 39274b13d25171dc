// What is asked by `halfdisk probe`, and what is answered?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/estimate.h"
#include "core/settings.h"

namespace halfdisk {

enum class Estimator : std::uint8_t { castRay };

inline constexpr std::array<Named<Estimator>, 1> kEstimators{{
    {Estimator::castRay, "cast-ray",
     "the published recursion: direct light, then N samples over the half-disk"},
}};

constexpr NumberInfo withInitial(NumberInfo info, std::uint64_t initial) {
    info.initial = initial;
    return info;
}

inline constexpr NumberInfo kProbeSamplesInfo = withInitial(kSamplesInfo, 64);
inline constexpr NumberInfo kRepeatsInfo{"repeat", "R", "independent repeats", 1, 1'000'000'000, 16};
inline constexpr NumberInfo kThreadsInfo{"threads", "threads", "threads; the answer does not depend on it",
                                         1,         256,       1};

/// More rays than this are refused unless the user insists: at 10^7 rays a second, a quarter of an hour.
inline constexpr double kMostProbeRays = 1e10;

/// As typed. probeQuestion makes sense of it.
struct ProbeTexts {
    std::string scene, at;
    std::optional<std::string> normal;
    std::string estimator{kEstimators.front().name};
    std::string samples = std::to_string(kProbeSamplesInfo.initial);
    std::string depth = std::to_string(kMaxDepthInfo.initial);
    std::string sampler{nameOf(kSamplers, Settings{}.sampler)};
    std::string emitters{nameOf(kEmitters, Settings{}.emitters)};
    std::string asPrinted;  ///< empty: none; "true": all
    std::string seed = std::to_string(kSeedInfo.initial);
    std::string repeats = std::to_string(kRepeatsInfo.initial);
    std::optional<std::string> threads;  ///< none: as many as the machine has
    bool anyway = false;
    bool json = false;
};

struct ProbeQuestion {
    Estimator estimator = Estimator::castRay;
    Settings settings;
    std::uint64_t repeats = kRepeatsInfo.initial;
    unsigned threads = 1;
    std::optional<Vec2> normal;  ///< unit
    bool anyway = false;
};

/// All but the place, which needs the scene. Throws InputError.
ProbeQuestion probeQuestion(const ProbeTexts& texts);

struct ProbePlace {
    ShadedPoint shaded;               ///< what is lit
    Vec2 at{0.0};                     ///< to print: on the wall itself if there is one, m
    std::optional<std::string> wall;  ///< its name
    bool radiance = false;            ///< the wall's front was asked for: its outgoing radiance is told too
};

/// Reads `X,Y` or `NAME:T`. Throws InputError, also where neither a wall nor a normal is.
ProbePlace probePlace(const SegmentIndex& index, const std::string& at, std::optional<Vec2> normal);

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
};

/// Throws InputError for more than kMostProbeRays rays, unless `anyway`.
ProbeAnswer probe(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place);

/// Exact E (W/m) by quadrature: for scenes of up to 60 walls, depths up to 1, and no defect switched on.
std::optional<Rgb> exactIrradiance(const Scene& scene, const Settings& settings, const ShadedPoint& at);

}  // namespace halfdisk
