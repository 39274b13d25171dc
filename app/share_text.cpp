#include "app/share_text.h"

#include <fmt/format.h>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/packed_text.h"
#include "lessons/scene_file.h"
#include "lessons/utf8.h"

namespace halfdisk {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kPrefix = "halfdisk.";
constexpr std::size_t kMostBytes = 16u << 20;  // of what a text holds: a scene of 10^5 walls

[[noreturn]] void failDamaged() {
    throw InputError(
        "the shared text is damaged or not from this program, expected all of what \"Copy state\" gave");
}

/// The text came whole, or it would not unpack: another version wrote it, or a hand.
[[noreturn]] void failValue(std::string_view key, const Json& json, std::string_view expected) {
    const std::string value = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    throw InputError(
        fmt::format("the shared text: \"{}\" is {}, expected {}", key, excerpt(value), expected));
}

const Json& valueOf(const Json& json, const char* key, std::string_view expected) {
    if (!json.contains(key))
        throw InputError(fmt::format("the shared text: \"{}\" is missing, expected {}", key, expected));
    return json[key];
}

Json jsonOf(const Maker& maker) {
    Json json{{"estimator", maker.estimator}, {"params", maker.params}};
    if (maker.depth) json["depth"] = *maker.depth;
    if (maker.specular) json["specular"] = *maker.specular;
    return json;
}

/// A whole number within what the window allows.
std::uint64_t whole(const Json& json, const char* key, std::uint64_t least, std::uint64_t most) {
    const std::string expected = fmt::format("a whole number from {} to {}", least, most);
    const Json& found = valueOf(json, key, expected);
    if (!found.is_number_unsigned()) failValue(key, found, expected);
    const auto value = found.get<std::uint64_t>();
    if (value < least || value > most) failValue(key, found, expected);
    return value;
}

template <class Enum, std::size_t Count>
Enum named(const Json& json, const char* key, const std::array<Named<Enum>, Count>& table) {
    std::string names;
    for (const Named<Enum>& one : table) names += fmt::format("{}{}", names.empty() ? "" : ", ", one.name);
    const std::string expected = fmt::format("one of {}", names);
    const Json& found = valueOf(json, key, expected);
    const auto value = found.is_string() ? valueOf(table, found.get<std::string>()) : std::nullopt;
    if (!value) failValue(key, found, expected);
    return *value;
}

Maker makerOfJson(const Json& json) {
    if (!json.is_object() || !json.contains("estimator") || !json["estimator"].is_string() ||
        !json.contains("params"))
        failDamaged();
    const EstimatorInfo* info = findEstimator(json["estimator"].get<std::string>());
    if (!info) failValue("estimator", json["estimator"], "one of those that halfdisk estimators lists");
    if (!json["params"].is_array() || json["params"].size() != info->params.size())
        failValue("params", json["params"], fmt::format("{} numbers", info->params.size()));
    Maker maker = makerOf(info->id);
    for (std::size_t i = 0; i < maker.params.size(); ++i) {
        const ParamInfo& param = info->params[i];
        const Json& found = json["params"][i];
        const bool choice = !param.choices.empty();
        const double least = choice ? 0.0 : param.least;
        const double most = choice ? static_cast<double>(param.choices.size()) - 1.0 : param.most;
        const double value = found.is_number() ? found.get<double>() : std::nan("");
        const bool fits = value >= least && value <= most;
        if (!fits || ((choice || param.whole) && value != std::floor(value)))
            failValue(param.name, found,
                      fmt::format("{} from {} to {}", choice || param.whole ? "a whole number" : "a number",
                                  least, most));
        maker.params[i] = value;
    }
    if (json.contains("depth")) maker.depth = static_cast<std::uint32_t>(whole(json, "depth", 0, 64));
    if (json.contains("specular"))
        maker.specular = static_cast<std::uint32_t>(
            whole(json, "specular", kMaxSpecularInfo.least, kMaxSpecularInfo.most));
    return maker;
}

void readSettings(const Json& json, Settings& settings) {
    settings.samples = static_cast<std::uint32_t>(whole(json, "samples", 1, kMostLessonSamples));
    settings.maxDepth = static_cast<std::uint32_t>(whole(json, "depth", 0, kMostLessonDepth));
    settings.seed = whole(json, "seed", 0, kSeedInfo.most);
    settings.sampler = named(json, "sampler", kSamplers);
    settings.emitters = named(json, "emitters", kEmitters);
    settings.defects.bits = static_cast<std::uint8_t>(whole(json, "defects", 0, DefectSet::all().bits));
}

double within(const Json& json, const char* key, double least, double most) {
    const std::string expected = fmt::format("a number from {} to {}", least, most);
    const Json& found = valueOf(json, key, expected);
    const double value = found.is_number() ? found.get<double>() : std::nan("");
    if (!(value >= least && value <= most)) failValue(key, found, expected);
    return value;
}

Json jsonOf(const InstrumentSettings& settings) {
    const DialSetting& dial = settings.dial;
    Json forced = Json::object();
    for (const Forced& one : settings.forced) forced[std::string(infoOf(one.id).name)] = one.value;
    return {{"scale", dial.scale},
            {"offset", dial.offset},
            {"gap", dial.gap},
            {"epsilon", dial.fixedEpsilon},
            {"precision", std::string(nameOf(kPrecisions, dial.precision))},
            {"policy", std::string(nameOf(kEpsilonPolicies, dial.policy))},
            {"wish", std::string(nameOf(kWishes, settings.wish))},
            {"error", settings.wishedError},
            {"milliseconds", settings.wishedMilliseconds},
            {"cost", std::string(nameOf(kTradeCosts, settings.tradeCost))},
            {"tolerance", settings.tolerance},
            {"forced", forced}};
}

InstrumentSettings instrumentsOf(const Json& json) {
    if (!json.is_object()) failValue("instruments", json, "an object");
    InstrumentSettings settings;
    settings.dial.scale = within(json, "scale", kLeastScale, kMostScale);
    settings.dial.offset = within(json, "offset", 0.0, kMostOffset);
    settings.dial.gap = within(json, "gap", 0.0, kMostGap);
    settings.dial.fixedEpsilon = within(json, "epsilon", kLeastEpsilon, kMostEpsilon);
    settings.dial.precision = named(json, "precision", kPrecisions);
    settings.dial.policy = named(json, "policy", kEpsilonPolicies);
    settings.wish = named(json, "wish", kWishes);
    settings.wishedError = within(json, "error", kLeastWishedError, kMostWishedError);
    settings.wishedMilliseconds = within(json, "milliseconds", kLeastMilliseconds, kMostMilliseconds);
    if (json.contains("cost")) settings.tradeCost = named(json, "cost", kTradeCosts);
    settings.tolerance = within(json, "tolerance", kLeastTolerance, kMostTolerance);
    const Json& forced = valueOf(json, "forced", "an object");
    if (!forced.is_object()) failValue("forced", forced, "an object");
    for (const RequirementInfo& info : kRequirements)
        if (forced.contains(std::string(info.name)) && info.kind != Switch::none)
            settings.forced.push_back({info.id, static_cast<std::uint32_t>(
                                                    whole(forced, std::string(info.name).c_str(), 0, 1000))});
    return settings;
}

AppState stateOf(const std::filesystem::path& lessonsFolder, const Json& json) {
    AppState state;
    SceneDescription scene;
    const bool ownScene = json.contains("scene");
    if (ownScene && !json["scene"].is_string()) failDamaged();
    if (ownScene) scene = parseScene(json["scene"].get<std::string>(), "the shared scene");
    if (json.contains("lesson") && json["lesson"].is_string()) {
        const auto step = static_cast<int>(whole(json, "step", 1, 200));
        state = openLesson(lessonsFolder, LessonRef{json["lesson"].get<std::string>(), step});
        if (ownScene) apply(state, EditScene{scene, std::nullopt, false});
    } else if (ownScene) {
        state = openDescribed(lessonsFolder, scene);
    } else {
        failDamaged();
    }
    if (!state.editing.message.empty()) throw InputError(state.editing.message);
    readSettings(json, state.settings);
    state.at.segment =
        static_cast<std::uint32_t>(whole(json, "wall", 0, state.scene->scene.segments.size() - 1));
    constexpr std::string_view kShare = "a number from 0 to 1";
    const Json& t = valueOf(json, "t", kShare);
    state.at.t = t.is_number() ? t.get<double>() : std::nan("");
    if (!(state.at.t >= 0.0 && state.at.t <= 1.0)) failValue("t", t, kShare);
    state.show.bits = static_cast<std::uint32_t>(whole(json, "show", 0, (1u << kViews.size()) - 1u));
    state.makers = {};
    if (json.contains("first")) state.makers.first = makerOfJson(json["first"]);
    if (json.contains("second")) state.makers.second = makerOfJson(json["second"]);
    if (json.contains("equal")) state.makers.equal = named(json, "equal", kBudgets);
    if (json.contains("scale")) state.scale = named(json, "scale", kFieldScales);
    state.instruments = {};
    if (json.contains("instruments")) state.instruments = instrumentsOf(json["instruments"]);
    state.strategiesAlone = json.contains("alone") && json["alone"] == true;
    if (json.contains("run")) state.run = named(json, "run", kRuns);
    state.pinnedPixel.reset();
    state.pinnedSide = Side::first;
    if (json.contains("pixel")) {
        const auto pixel = static_cast<std::uint32_t>(whole(json, "pixel", 0, kEyeStripPixels - 1));
        if (!canPin(state, pixel)) failValue("pixel", json["pixel"], "none: no strip of an eye is shown");
        state.pinnedPixel = pixel;
        if (json.contains("pixelOf")) state.pinnedSide = named(json, "pixelOf", kSides);
        if (state.pinnedSide == Side::second && !state.makers.second)
            failValue("pixelOf", json["pixelOf"], "A: nothing is compared with it");
    }
    state.playback.stepping = json.contains("event");
    state.playback.event = state.playback.stepping ? whole(json, "event", 0, UINT32_MAX) : 0;
    ++state.questionId;
    return state;
}

}  // namespace

std::string shareText(const AppState& state) {
    Json json;
    const bool ofLesson = state.lesson && state.sceneOverride.empty();
    if (ofLesson) {
        json["lesson"] = state.lesson->slug;
        json["step"] = state.step + 1;
    }
    SceneDescription scene = state.scene->description;
    if (!ofLesson || !(scene == state.lesson->scene)) {
        scene.environment.image.clear();  // the picture's colours go along instead of its name
        json["scene"] = writeScene(scene);
    }
    const Settings& settings = state.settings;
    json["samples"] = settings.samples;
    json["depth"] = settings.maxDepth;
    json["seed"] = settings.seed;
    json["sampler"] = std::string(nameOf(kSamplers, settings.sampler));
    json["emitters"] = std::string(nameOf(kEmitters, settings.emitters));
    json["defects"] = settings.defects.bits;
    json["wall"] = state.at.segment;
    json["t"] = state.at.t;
    json["show"] = state.show.bits;
    if (state.makers.first) json["first"] = jsonOf(*state.makers.first);
    if (state.makers.second) json["second"] = jsonOf(*state.makers.second);
    if (state.makers.equal != Budget::rays) json["equal"] = std::string(nameOf(kBudgets, state.makers.equal));
    if (state.scale != FieldScale::light) json["scale"] = std::string(nameOf(kFieldScales, state.scale));
    if (!(state.instruments == InstrumentSettings{})) json["instruments"] = jsonOf(state.instruments);
    if (state.strategiesAlone) json["alone"] = true;
    if (state.run != Run::castRay) json["run"] = std::string(nameOf(kRuns, state.run));
    if (state.pinnedPixel) json["pixel"] = *state.pinnedPixel;
    if (state.pinnedSide == Side::second) json["pixelOf"] = std::string(nameOf(kSides, state.pinnedSide));
    if (state.playback.stepping) json["event"] = state.playback.event;
    return std::string(kPrefix) + packedText(json.dump());
}

bool isShareText(std::string_view text) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    return start != std::string_view::npos && text.substr(start, kPrefix.size()) == kPrefix;
}

AppState openShared(const std::filesystem::path& lessonsFolder, std::string_view text) {
    if (!isShareText(text)) failDamaged();
    const std::string_view body = text.substr(text.find(kPrefix) + kPrefix.size());
    const std::optional<std::string> unpacked = unpackedText(body, kMostBytes);
    if (!unpacked) failDamaged();
    const Json json = Json::parse(*unpacked, nullptr, false);
    if (!json.is_object()) failDamaged();
    return stateOf(lessonsFolder, json);
}

}  // namespace halfdisk
