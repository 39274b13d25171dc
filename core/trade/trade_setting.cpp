// What can be chosen when light is to be computed? An estimator, its parameters, and what the scene is made
// of.
#include "core/trade/trade_setting.h"

#include <cmath>
#include <cstdio>

namespace halfdisk {
namespace {

/// The shortest text that keeps the number.
std::string textOf(double value) {
    char text[40];
    for (const int digits : {6, 15, 17}) {
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        if (std::strtod(text, nullptr) == value) break;
    }
    return text;
}

std::string textOf(const ParamInfo& param, double value) {
    if (!param.choices.empty()) return std::string(param.choices[static_cast<std::size_t>(value)]);
    return textOf(value);
}

bool inRange(const ParamInfo& param, double value) {
    return value >= param.least && value <= param.most;
}

/// Other values than the initial one that are worth a look.
std::vector<double> variationsOf(const ParamInfo& param) {
    std::vector<double> values;
    if (!param.choices.empty()) {
        for (std::size_t i = 0; i < param.choices.size(); ++i)
            if (static_cast<double>(i) != param.initial) values.push_back(static_cast<double>(i));
        return values;
    }
    if (!(param.initial > 0.0)) return values;  // "none" or "all": no scale to go by
    for (const double factor : {0.25, 4.0}) {
        const double scaled = factor * param.initial, value = param.whole ? std::round(scaled) : scaled;
        if (inRange(param, value) && value != param.initial) values.push_back(value);
    }
    return values;
}

}  // namespace

std::string nameOf(const TradeSetting& setting, std::uint32_t askedDepth) {
    std::string name(setting.estimator->id);
    const auto add = [&](std::string_view key, const std::string& value) {
        name += ' ';
        name += key;
        name += '=';
        name += value;
    };
    for (std::size_t i = 0; i < setting.params.size(); ++i) {
        const ParamInfo& param = setting.estimator->params[i];
        if (setting.params[i] != param.initial) add(param.name, textOf(param, setting.params[i]));
    }
    if (setting.maxDepth != askedDepth) add("depth", std::to_string(setting.maxDepth));
    if (setting.facets != 1.0) add("facets", textOf(setting.facets));
    if (precisionOf(setting.index) != Precision::twice)
        add("precision", std::string(nameOf(kPrecisions, precisionOf(setting.index))));
    else if (setting.index != IndexMethod::automatic)
        add("index", std::string(nameOf(kIndexMethods, setting.index)));
    return name;
}

std::string_view whyNotSwept(const EstimatorInfo& info, std::string_view param) {
    // The radius of pass n depends on n, so that no pass estimates what another one does.
    if (info.id == "photon-map" && param == "shrink")
        return "shrinks the radius from pass to pass: passes then are not alike, and an error that is "
               "measured "
               "over some says nothing of others";
    return {};
}

std::vector<TradeSetting> defaultSettings(const EstimatorInfo& info, std::uint32_t maxDepth) {
    const TradeSetting initial{&info, initialValues(info), maxDepth};
    std::vector<TradeSetting> settings{initial};
    for (std::size_t i = 0; i < info.params.size(); ++i) {
        if (!whyNotSwept(info, info.params[i].name).empty()) continue;
        for (const double value : variationsOf(info.params[i])) {
            settings.push_back(initial);
            settings.back().params[i] = value;
        }
    }
    return settings;
}

}  // namespace halfdisk
