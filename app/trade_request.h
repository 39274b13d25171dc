// What is asked by `halfdisk trade`? As typed, then with the scene: sensor, settings, reference.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/cli_output.h"
#include "app/render_sensor.h"
#include "core/trade/trade_report.h"
#include "lessons/scene_file.h"

namespace halfdisk {

inline constexpr double kTradeSeconds = 1.0;     ///< a setting, if nothing is said
inline constexpr double kReferenceShare = 16.0;  ///< a long reference's budget, in settings' budgets
inline constexpr std::size_t kMostTradeCells = 2000;
inline constexpr std::uint32_t kMostTradePixels = 1u << 18;  ///< 32 pictures are kept at once

/// As typed. Empty: not given.
struct TradeTexts {
    std::string scene;
    std::optional<std::string> sensor, walls, at, normal;  ///< where light is measured
    std::optional<std::string> width, height;
    std::string estimators = "all";
    std::vector<std::string> sweeps;
    std::optional<std::string> budget, rays, threads, part, output;
    std::string target = "0.05", reference = "auto";
    std::string depth = std::to_string(kMaxDepthInfo.initial);
    std::string specular = std::to_string(kMaxSpecularInfo.initial);
    std::string seed = std::to_string(kSeedInfo.initial);
    bool json = false;
};

/// A scene with so many times the facets, ready for rays by one kind of index; it does not move.
struct TradeScene {
    Scene scene;
    SegmentIndex index;
    Sensor sensor;

    TradeScene(Scene made, IndexMethod method, const std::function<Sensor(const SegmentIndex&)>& sensorOf)
        : scene(std::move(made)), index(scene, method), sensor(sensorOf(index)) {}
    TradeScene(const TradeScene&) = delete;
    TradeScene& operator=(const TradeScene&) = delete;
};

struct TradeRequest {
    TradeTexts texts;
    SceneDescription description;
    std::string sensorName;
    std::uint32_t maxDepth = 0, maxSpecular = 0;
    std::uint64_t seed = 0;
    double target = 0.05;
    PassBudget budget;  ///< of a setting
    std::size_t part = 0, parts = 1;
    std::vector<TradeSetting> settings;
    std::map<std::pair<double, IndexMethod>, std::unique_ptr<TradeScene>> scenes;  ///< by facets and index

    const TradeScene& sceneOf(const TradeSetting& setting) const;
    const TradeScene& asked() const;  ///< as the file has it
    Problem problemOf(const TradeSetting& setting, const StopQuestion& stop) const;
    Problem problem(const StopQuestion& stop) const;  ///< as asked, for the reference
};

/// Loads the scene too. Throws InputError.
TradeRequest tradeRequest(const TradeTexts& texts);

/// What is asked for, as the files of `halfdisk eye` and the like tell it: by it a reference is known.
Json pictureFacts(const TradeRequest& request);

/// All on which the measured numbers depend, for files: what differs is another question.
Json questionJson(const TradeRequest& request);

}  // namespace halfdisk
