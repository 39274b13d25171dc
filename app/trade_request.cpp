// What is asked by `halfdisk trade`? As typed, then with the scene: sensor, settings, reference.
#include "app/trade_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli.h"
#include "app/cli_arguments.h"
#include "app/cli_probe.h"
#include "app/estimator_arguments.h"
#include "app/scene_hash.h"
#include "app/trade_sweep.h"

namespace halfdisk {
namespace {

constexpr std::string_view kProbeName = "probe";
constexpr std::uint32_t kStripPixels = 128, kFieldPixels = 48;

std::string sensorNames() {
    return fmt::format("{}, {}", joinedNames(kPictureSensors), kProbeName);
}

/// The eye if there is one, else all walls.
std::string sensorNameOf(const TradeTexts& texts, const Scene& scene) {
    if (!texts.sensor) return texts.at ? "probe" : texts.walls || !scene.eye ? "profile" : "eye";
    if (*texts.sensor != kProbeName && !valueOf(kPictureSensors, *texts.sensor))
        failArgument("--sensor", *texts.sensor, fmt::format("is unknown, expected one of {}", sensorNames()));
    return *texts.sensor;
}

Sensor probeOf(const TradeTexts& texts, const SegmentIndex& index) {
    if (!texts.at) throw InputError("--sensor probe needs a place, expected --at X,Y or --at WALL:T");
    std::optional<Vec2> normal;
    if (texts.normal) normal = directionArgument("--normal", *texts.normal);
    return Probe{probePlace(index, *texts.at, normal).shaded};
}

Sensor sensorOf(const TradeTexts& texts, const std::string& name, const SegmentIndex& index) {
    if (name == kProbeName) return probeOf(texts, index);
    RenderRequest request;
    request.sensor = *valueOf(kPictureSensors, name);
    request.texts.scene = texts.scene;
    request.texts.walls = texts.walls.value_or("all");
    const bool field = request.sensor == PictureSensor::field;
    request.texts.width = texts.width.value_or(std::to_string(field ? kFieldPixels : kStripPixels));
    if (field) request.texts.height = texts.height;
    Sensor sensor = pictureOf(request, index.scene()).sensor;
    if (pixelCount(sensor) > kMostTradePixels)
        throw InputError(
            fmt::format("--width, --height: {} pixels are too many for 32 pictures at once, "
                        "expected at most {}",
                        pixelCount(sensor), kMostTradePixels));
    return sensor;
}

void refuseForeignOptions(const TradeTexts& texts, const std::string& sensor) {
    const auto refuse = [&](const std::optional<std::string>& given, const char* option, const char* owner) {
        if (given && sensor != owner)
            throw InputError(fmt::format("{} is for --sensor {} only, not for {}", option, owner, sensor));
    };
    refuse(texts.walls, "--walls", "profile");
    refuse(texts.at, "--at", "probe");
    refuse(texts.normal, "--normal", "probe");
    refuse(texts.height, "--height", "field");
    if (texts.width && sensor == kProbeName)
        throw InputError("--width is not for --sensor probe: it is one number");
}

PassBudget budgetOf(const TradeTexts& texts) {
    if (texts.budget && texts.rays)
        throw InputError("--budget and --rays exclude each other, expected one of them");
    PassBudget budget;
    constexpr double kMostRays = 1e15;
    if (texts.rays)
        budget.rays = numberArgument("--rays", *texts.rays, 1.0, kMostRays);
    else
        budget.seconds =
            texts.budget ? numberArgument("--budget", *texts.budget, 1e-3, kMostSeconds) : kTradeSeconds;
    budget.threads = threadsArgument(texts.threads);
    return budget;
}

/// `2/8`: the second of eight.
void readPart(const std::string& text, TradeRequest& request) {
    const std::size_t slash = text.find('/');
    constexpr std::uint64_t kMostParts = 100'000;
    const auto number = [&](std::string_view digits) { return parseWhole(digits); };
    if (slash != std::string::npos) {
        const auto part = number(std::string_view(text).substr(0, slash)),
                   parts = number(std::string_view(text).substr(slash + 1));
        if (part && parts && *part >= 1 && *part <= *parts && *parts <= kMostParts) {
            request.part = *part - 1;
            request.parts = *parts;
            return;
        }
    }
    failArgument("--part", text, "is no part, expected I/N with I from 1 to N, such as 1/4");
}

/// Round things with so many times the facets; at least what a shape needs.
SceneDescription withFacets(SceneDescription description, double factor) {
    const auto scaled = [factor](std::uint32_t segments, double least) {
        return static_cast<std::uint32_t>(
            std::clamp(std::round(segments * factor), least, double{kMaxSegments}));
    };
    for (Shape& shape : description.shapes) {
        if (auto* circle = std::get_if<CircleShape>(&shape.geometry))
            circle->segments = scaled(circle->segments, 3.0);
        if (auto* arc = std::get_if<ArcShape>(&shape.geometry)) arc->segments = scaled(arc->segments, 1.0);
        if (auto* lens = std::get_if<LensShape>(&shape.geometry))
            lens->segments = scaled(lens->segments, 1.0);
    }
    return description;
}

void refuseTooManyWalls(const SceneDescription& description, double factor) {
    std::uint64_t walls = 0;
    for (const Shape& shape : description.shapes) walls += edgeCount(shape.geometry);
    if (walls > kMaxSegments)
        throw InputError(fmt::format("--sweep: facets={:g} makes {} walls, expected at most {}", factor,
                                     walls, kMaxSegments));
}

void prepareScenes(TradeRequest& request) {
    const auto prepare = [&](double facets, IndexMethod method) {
        auto& scene = request.scenes[{facets, method}];
        if (scene) return;
        const SceneDescription description =
            facets == 1.0 ? request.description : withFacets(request.description, facets);
        refuseTooManyWalls(description, facets);
        scene = std::make_unique<TradeScene>(
            expandScene(description), method,
            [&](const SegmentIndex& index) { return sensorOf(request.texts, request.sensorName, index); });
    };
    prepare(1.0, IndexMethod::automatic);
    for (const TradeSetting& setting : request.settings) prepare(setting.facets, setting.index);
}

}  // namespace

const TradeScene& TradeRequest::sceneOf(const TradeSetting& setting) const {
    return *scenes.at({setting.facets, setting.index});
}

const TradeScene& TradeRequest::asked() const {
    return *scenes.at({1.0, IndexMethod::automatic});
}

Problem TradeRequest::problemOf(const TradeSetting& setting, const StopQuestion& stop) const {
    const TradeScene& scene = sceneOf(setting);
    return {scene.index, scene.sensor, setting.maxDepth, maxSpecular, seed, stop};
}

Problem TradeRequest::problem(const StopQuestion& stop) const {
    return {asked().index, asked().sensor, maxDepth, maxSpecular, seed, stop};
}

TradeRequest tradeRequest(const TradeTexts& texts) {
    TradeRequest request;
    request.texts = texts;
    request.maxDepth = static_cast<std::uint32_t>(wholeArgument("--depth", texts.depth, kMaxDepthInfo));
    request.maxSpecular =
        static_cast<std::uint32_t>(wholeArgument("--specular", texts.specular, kMaxSpecularInfo));
    request.seed = wholeArgument("--seed", texts.seed, kSeedInfo);
    request.target = numberArgument("--target", texts.target, kLeastTradeError, kMostTradeError);
    request.budget = budgetOf(texts);
    if (texts.part) readPart(*texts.part, request);
    if (request.parts > 1 && !texts.output)
        throw InputError("--part needs a folder to keep what it measures, expected -o DIR");
    request.description = loadScene(texts.scene);
    const Scene scene = expandScene(request.description);
    request.sensorName = sensorNameOf(texts, scene);
    refuseForeignOptions(texts, request.sensorName);
    request.settings = tradeSettings(texts.estimators, texts.sweeps, request.maxDepth);
    // The truth is the deepest of what is compared: else the setting nearest to it would be called biased.
    for (const TradeSetting& setting : request.settings)
        request.maxDepth = std::max(request.maxDepth, setting.maxDepth);
    prepareScenes(request);
    // Those that do not serve the sensor are no choice at all; other refusals are told.
    const unsigned bit = bitOf(request.asked().sensor);
    const auto serves = [bit](const TradeSetting& setting) {
        return (setting.estimator->sensors & bit) != 0;
    };
    if (std::none_of(request.settings.begin(), request.settings.end(), serves))
        throw InputError(fmt::format("--estimators: none of '{}' serves the sensor {}", texts.estimators,
                                     request.sensorName));
    std::erase_if(request.settings, [&](const TradeSetting& setting) { return !serves(setting); });
    return request;
}

Json pictureFacts(const TradeRequest& request) {
    const TradeScene& scene = request.asked();
    Json facts{{"sceneHash", sceneHash(request.description)},
               {"depth", request.maxDepth},
               {"specular", request.maxSpecular}};
    if (request.sensorName == kProbeName) return facts;
    facts["sensor"] = request.sensorName;
    facts[request.sensorName] = sensorFacts({scene.sensor, 0, 0}, scene.index);
    return facts;
}

Json questionJson(const TradeRequest& request) {
    const TradeTexts& texts = request.texts;
    const auto given = [](const std::optional<std::string>& text) {
        return text ? Json(*text) : Json(nullptr);
    };
    Json question;
    question["program"] = fmt::format("halfdisk {}", kVersion);
    question["scene"] = sceneHash(request.description);
    question["sensor"] = request.sensorName;
    question["walls"] = given(texts.walls);
    question["at"] = given(texts.at);
    question["normal"] = given(texts.normal);
    question["width"] = given(texts.width);
    question["height"] = given(texts.height);
    question["depth"] = request.maxDepth;
    question["specular"] = request.maxSpecular;
    question["seed"] = request.seed;
    question["rays"] = request.budget.rays;
    question["seconds"] = request.budget.seconds;
    question["reference"] = texts.reference;
    Json settings = Json::array();
    for (const TradeSetting& setting : request.settings)
        settings.push_back(nameOf(setting, request.maxDepth));
    question["settings"] = settings;
    return question;
}

}  // namespace halfdisk
