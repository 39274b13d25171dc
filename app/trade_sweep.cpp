// Which settings are compared? From a list of estimators and what is swept.
#include "app/trade_sweep.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli_arguments.h"
#include "app/estimator_arguments.h"
#include "app/trade_request.h"

namespace halfdisk {
namespace {

constexpr double kLeastFacets = 1e-3, kMostFacets = 1e3;

struct Sweep {
    std::string text, estimator, key;  ///< estimator: empty for all
    std::vector<std::string> values;
    bool used = false;
};

std::vector<std::string> splitAtCommas(std::string_view text) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t comma = text.find(',');
        parts.emplace_back(text.substr(0, comma));
        if (comma == std::string_view::npos) return parts;
        text.remove_prefix(comma + 1);
    }
}

Sweep sweepOf(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        failArgument("--sweep", text, "is no sweep, expected KEY=VALUE,VALUE,...");
    Sweep sweep;
    sweep.text = text;
    sweep.key = text.substr(0, equals);
    if (const std::size_t dot = sweep.key.find('.'); dot != std::string::npos) {
        sweep.estimator = estimatorArgument(sweep.key.substr(0, dot)).id;
        sweep.key = sweep.key.substr(dot + 1);
    }
    sweep.values = splitAtCommas(std::string_view(text).substr(equals + 1));
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
        if (sweep.values[i].empty()) failArgument("--sweep", text, "has an empty value");
        if (std::find(sweep.values.begin(), sweep.values.begin() + static_cast<std::ptrdiff_t>(i),
                      sweep.values[i]) != sweep.values.begin() + static_cast<std::ptrdiff_t>(i))
            failArgument("--sweep", text, fmt::format("has '{}' twice", sweep.values[i]));
    }
    return sweep;
}

bool hasParam(const EstimatorInfo& info, std::string_view name) {
    return std::any_of(info.params.begin(), info.params.end(),
                       [&](const ParamInfo& param) { return param.name == name; });
}

/// Refused in the name of the sweep.
ParamValues sweptParam(const Sweep& sweep, const std::string& value, const EstimatorInfo& info) {
    try {
        return paramArguments(info, {fmt::format("{}={}", sweep.key, value)});
    } catch (const InputError& refused) {
        const std::size_t option = refused.text.find(": ");
        throw InputError(
            fmt::format("--sweep{}", refused.text.substr(std::min(option, refused.text.size()))));
    }
}

/// One of a sweep's values put into a setting.
void apply(const Sweep& sweep, const std::string& value, TradeSetting& setting) {
    if (sweep.key == "depth") {
        setting.maxDepth = static_cast<std::uint32_t>(wholeArgument("--sweep: depth", value, kMaxDepthInfo));
    } else if (sweep.key == "facets") {
        setting.facets = numberArgument("--sweep: facets", value, kLeastFacets, kMostFacets);
    } else if (sweep.key == "index") {
        setting.index = namedArgument("--sweep: index", value, kIndexMethods);
    } else if (sweep.key == "precision") {
        if (namedArgument("--sweep: precision", value, kPrecisions) == Precision::single)
            setting.index = IndexMethod::single;
    } else {
        const ParamValues given = sweptParam(sweep, value, *setting.estimator);
        for (std::size_t i = 0; i < given.size(); ++i)
            if (setting.estimator->params[i].name == sweep.key) setting.params[i] = given[i];
    }
}

bool isOfScene(const Sweep& sweep) {
    return sweep.key == "depth" || sweep.key == "facets" || sweep.key == "index" || sweep.key == "precision";
}

bool hasValue(const Sweep& sweep, std::string_view value) {
    return std::find(sweep.values.begin(), sweep.values.end(), value) != sweep.values.end();
}

/// Float is a way of its own to find walls: no other one has it.
void refuseTwoWays(const Sweep& index, const Sweep& precision) {
    const bool sameEstimator =
        index.estimator.empty() || precision.estimator.empty() || index.estimator == precision.estimator;
    const std::string single(nameOf(kIndexMethods, IndexMethod::single)),
        automatic(nameOf(kIndexMethods, IndexMethod::automatic));
    const bool both = hasValue(precision, nameOf(kPrecisions, Precision::single)) &&
                      (index.values.size() > 1 || index.values[0] != automatic);
    if (sameEstimator && (both || hasValue(index, single)))
        failArgument("--sweep", precision.text,
                     fmt::format("does not go with {}: every other index decides in double, expected one of "
                                 "these two sweeps",
                                 index.text));
}

/// Whether an estimator has what is swept.
bool applies(const Sweep& sweep, const EstimatorInfo& info) {
    if (!sweep.estimator.empty() && sweep.estimator != info.id) return false;
    return isOfScene(sweep) || hasParam(info, sweep.key);
}

std::vector<const EstimatorInfo*> estimatorsArgument(const std::string& text) {
    std::vector<const EstimatorInfo*> infos;
    if (text == "all") {
        for (const EstimatorInfo* info : estimators()) infos.push_back(info);
        return infos;
    }
    for (const std::string& id : splitAtCommas(text)) {
        if (!findEstimator(id)) {
            std::vector<std::string_view> ids{"all"};
            for (const EstimatorInfo* info : estimators()) ids.push_back(info->id);
            failArgument("--estimators", id, fmt::format("is unknown, {}", expectedOneOf(id, ids)));
        }
        const EstimatorInfo& info = *findEstimator(id);
        if (std::find(infos.begin(), infos.end(), &info) != infos.end())
            failArgument("--estimators", text, fmt::format("names {} twice", id));
        infos.push_back(&info);
    }
    return infos;
}

void refuseTooMany(std::size_t count) {
    if (count > kMostTradeCells)
        throw InputError(
            fmt::format("--sweep: these are more than {} settings, expected fewer values", kMostTradeCells));
}

std::vector<TradeSetting> product(const EstimatorInfo& info, std::vector<Sweep>& sweeps,
                                  std::uint32_t maxDepth) {
    std::vector<TradeSetting> settings{{&info, initialValues(info), maxDepth}};
    for (Sweep& sweep : sweeps) {
        if (!applies(sweep, info)) continue;
        if (const std::string_view why = whyNotSwept(info, sweep.key); !why.empty() && !isOfScene(sweep))
            failArgument("--sweep", sweep.text, std::string(why));
        sweep.used = true;
        std::vector<TradeSetting> more;
        refuseTooMany(settings.size() * sweep.values.size());
        for (const TradeSetting& setting : settings)
            for (const std::string& value : sweep.values) {
                more.push_back(setting);
                apply(sweep, value, more.back());
            }
        settings = std::move(more);
    }
    return settings;
}

}  // namespace

std::vector<TradeSetting> tradeSettings(const std::string& estimators,
                                        const std::vector<std::string>& sweepTexts, std::uint32_t maxDepth) {
    std::vector<Sweep> sweeps;
    for (const std::string& text : sweepTexts) {
        sweeps.push_back(sweepOf(text));
        for (std::size_t i = 0; i + 1 < sweeps.size(); ++i)
            if (sweeps[i].key == sweeps.back().key && sweeps[i].estimator == sweeps.back().estimator)
                failArgument("--sweep", text,
                             "sweeps what another one does, expected all values in one list");
        for (const Sweep& other : sweeps) {
            if (other.key == "index" && sweeps.back().key == "precision") refuseTwoWays(other, sweeps.back());
            if (other.key == "precision" && sweeps.back().key == "index") refuseTwoWays(sweeps.back(), other);
        }
    }
    std::vector<TradeSetting> settings;
    for (const EstimatorInfo* info : estimatorsArgument(estimators)) {
        const std::vector<TradeSetting> own =
            sweeps.empty() ? defaultSettings(*info, maxDepth) : product(*info, sweeps, maxDepth);
        // Two texts of one value, 1 and 1.0, are one setting.
        for (const TradeSetting& setting : own)
            if (std::find(settings.begin(), settings.end(), setting) == settings.end())
                settings.push_back(setting);
        refuseTooMany(settings.size());
    }
    for (const Sweep& sweep : sweeps)
        if (!sweep.used)
            failArgument(
                "--sweep", sweep.text,
                fmt::format(
                    "sweeps what none of the estimators has; expected a parameter of one of them (halfdisk "
                    "estimators tells them), depth, facets, index or precision"));
    return settings;
}

}  // namespace halfdisk
