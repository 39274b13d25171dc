// What is asked by `halfdisk eye`, `profile` and `field`? As typed, and checked as far as the scene is not
// needed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/estimator_arguments.h"
#include "app/measurement.h"
#include "app/requirements_arguments.h"

namespace halfdisk {

/// The sensors that make pictures. Names and meanings are those of the commands.
enum class PictureSensor : std::uint8_t { eye, profile, field };
inline constexpr std::array<Named<PictureSensor>, 3> kPictureSensors{{
    {PictureSensor::eye, "eye", "see the scene through a pinhole: a strip of pixels"},
    {PictureSensor::profile, "profile", "measure the irradiance along walls, in bins"},
    {PictureSensor::field, "field", "measure the fluence over a grid of the plane"},
}};

inline constexpr NumberInfo kPassesInfo{"samples", "N",           "samples of every pixel (of light: passes)",
                                        1,         1'000'000'000, 64};
inline constexpr double kMostSeconds = 86400.0;
inline constexpr std::uint64_t kMostPicturePixels = 4'000'000;  ///< width times height
inline constexpr std::uint32_t kMostPictureWidth = 65536;
inline constexpr double kMostExposure = 64.0;  ///< EV, up or down

/// More samples of pixels than this are refused unless the user insists: at 10^7 a second, three hours.
inline constexpr double kMostPixelSamples = 1e11;

/// As typed. Empty: not given.
struct RenderTexts {
    std::string scene;
    std::string estimator{kDefaultEstimator};
    std::optional<std::string> samples, seconds, threads, width, height, exposure;
    std::vector<std::string> params, outputs;
    std::string depth = std::to_string(kMaxDepthInfo.initial);
    std::string specular = std::to_string(kMaxSpecularInfo.initial);
    std::string seed = std::to_string(kSeedInfo.initial);
    bool anyway = false, json = false;
    PlanTexts plan;

    std::optional<std::string> position, direction, fov;  ///< of the eye
    std::string walls;                                    ///< of the profile
    std::optional<std::string> min, max;                  ///< of the field
};

struct RenderRequest {
    PictureSensor sensor = PictureSensor::eye;
    RenderTexts texts;      ///< what the sensor is made from, once the scene is there
    std::string sceneHash;  ///< see there; once the scene is there
    const EstimatorInfo* estimator = nullptr;
    ParamValues params;
    std::uint32_t maxDepth = 0, maxSpecular = 0;
    std::uint64_t seed = 0;
    PlanRequest plan;  ///< automatic: estimator and params are not known yet
    MeasureLimits limits;
    std::optional<double> exposure;  ///< EV: factor 2^EV; none: automatic
    std::vector<std::filesystem::path> outputs;
};

/// Throws InputError; also for outputs that could not be written.
RenderRequest renderRequest(PictureSensor sensor, const RenderTexts& texts);

/// Throws InputError if that many pixels take too long and the user did not insist.
void refuseTooManySamples(const RenderRequest& request, std::uint32_t pixels);

/// Arguments of `halfdisk` that give the same result again, whatever the defaults become, but for `-o`.
/// Quoted for a shell. `samples` is how many were really made; width and height are the picture's.
std::string commandFor(const RenderRequest& request, std::uint64_t samples, std::uint32_t width,
                       std::uint32_t height);

}  // namespace halfdisk
