// What is an estimator, and what does it say of itself? One file and one line in estimators.cpp each.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "film.h"
#include "light_table.h"
#include "sensor.h"
#include "stop.h"

namespace halfdisk {

class PathRecorder;

/// What is asked of an estimator. Everything outlives it and stays as it is.
struct Problem {
    const SegmentIndex& index;
    const Sensor& sensor;
    std::uint32_t maxDepth =
        kMaxDepthInfo.initial;  ///< irradiance and fluence at this depth, radiance at one more
    std::uint32_t maxSpecular = kMaxSpecularInfo.initial;  ///< mirror and glass events in a row
    std::uint64_t seed = kSeedInfo.initial;
    /// Calls preparation and passes off: within 16 rays, wherever they are (see stop.h).
    StopQuestion stop{};
    /// Is told every step of a pass by estimators that say so (EstimatorInfo::recorded); one pass at a time.
    PathRecorder* record = nullptr;
};

/// A parameter of an estimator: a number, or one of the `choices` (its value is the choice's place in the
/// list).
struct ParamInfo {
    std::string_view name;
    std::string_view meaning;
    std::string_view unit{};  ///< empty: none
    double least = 0.0, most = 1.0, initial = 0.0;
    bool whole = false;  ///< whole numbers only
    std::span<const std::string_view>
        choices{};                      ///< not empty: a choice; least, most and whole follow from it
    std::optional<double> firstLook{};  ///< with this it has a picture at once, if a worse one
};

/// One value for each entry of EstimatorInfo::params, in that order.
using ParamValues = std::vector<double>;

class Estimator {
 public:
    virtual ~Estimator() = default;

    /// One independent estimate of every pixel: adds to `picture` (black, one entry a pixel). The same pass
    /// gives the same bits on any thread; called by several at once. Throws Stopped if Problem::stop says so;
    /// the picture and the counts are then of no use.
    virtual void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const = 0;

    /// About how many paths a pass follows besides one for each pixel: what decides how many passes are one
    /// piece of work.
    virtual double workPerPass() const { return 0.0; }
};

/// How an estimator is found, explained and made.
struct EstimatorInfo {
    std::string_view id;
    std::string_view title;
    std::string_view meaning;  ///< one line
    unsigned sensors;          ///< SensorBits that it serves
    std::span<const ParamInfo> params;
    std::string_view bias;  ///< empty: none; else where it comes from and how it shrinks
    bool recorded = false;  ///< it tells Problem::record every step

    /// Which paths it can carry to the sensor in this scene: a regular expression over L (light), D (diffuse
    /// or glossy), S (mirror or glass) and E (the sensor).
    std::string (*paths)(const Scene& scene, unsigned sensorBit);
    /// Whether it carries light of all bounces, whatever Problem::maxDepth says. Null: never.
    bool (*endless)(const ParamValues& params) = nullptr;
    /// Empty, or why it can't do this, in words for the user. May be null: it can do all that its sensors
    /// promise.
    std::string (*refusal)(const Problem& problem, const ParamValues& params);
    /// Prepares it (patches, tables). May throw std::invalid_argument with the message of a refusal found on
    /// the way, and Stopped if problem.stop says so.
    std::unique_ptr<Estimator> (*make)(const Problem& problem, const ParamValues& params);
};

inline unsigned bitOf(const Sensor& sensor) {
    return 1u << sensor.index();
}

ParamValues initialValues(const EstimatorInfo& info);

/// Why `info` can't be asked for this; empty if it can. Checks sensor and parameters, then the estimator's
/// own refusal.
std::string refusalOf(const EstimatorInfo& info, const Problem& problem, const ParamValues& params);

/// Whether the scene holds lights or materials of a kind: what decides which paths there are.
struct SceneTraits {
    bool delta = false;     ///< point or directional lights
    bool area = false;      ///< emitting segments or an environment
    bool specular = false;  ///< mirrors or glass, also in a mix
    bool glass = false;
    bool scattering = false;  ///< diffuse or glossy walls
    bool diffuseOnly = true;  ///< every wall is flat and diffuse
};
SceneTraits traitsOf(const Scene& scene);

/// L(S|D)*E, less what the scene lacks.
std::string allPaths(const Scene& scene);

/// Scatterings (not specular) that a path seen by this sensor may have: an eye sees radiance, which is one
/// deeper than irradiance.
inline std::uint32_t mostScatterings(const Problem& problem) {
    const bool radiance =
        std::holds_alternative<EyeStrip>(problem.sensor) || std::holds_alternative<Look>(problem.sensor);
    return problem.maxDepth + (radiance ? 1 : 0);
}

}  // namespace halfdisk
