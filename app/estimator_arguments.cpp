// Which estimator is asked for, and with which values of its parameters? All from the registry's own table.
#include "app/estimator_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli_arguments.h"

namespace halfdisk {
namespace {

constexpr std::string_view kOption = "--param";

std::size_t paramOfName(const EstimatorInfo& info, std::string_view text, std::string_view name) {
    std::vector<std::string_view> names;
    for (const ParamInfo& param : info.params) names.push_back(param.name);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    if (names.empty()) failArgument(kOption, text, fmt::format("is too much: {} has no parameters", info.id));
    failArgument(kOption, text,
                 fmt::format("names no parameter of {}, {}", info.id, expectedOneOf(name, names)));
}

/// Whole numbers, also those below zero.
std::optional<double> signedWhole(std::string_view text) {
    const bool negative = !text.empty() && text.front() == '-';
    const auto whole = parseWhole(negative ? text.substr(1) : text);
    if (!whole) return std::nullopt;
    return negative ? -static_cast<double>(*whole) : static_cast<double>(*whole);
}

double valueOf(const ParamInfo& param, std::string_view text, std::string_view value) {
    if (!param.choices.empty()) {
        const auto found = std::find(param.choices.begin(), param.choices.end(), value);
        if (found != param.choices.end()) return static_cast<double>(found - param.choices.begin());
        failArgument(kOption, text,
                     fmt::format("is no choice of {}, {}", param.name,
                                 expectedOneOf(value, {param.choices.begin(), param.choices.end()})));
    }
    const auto number = param.whole ? signedWhole(value) : parseNumber(value);
    if (!number || *number < param.least || *number > param.most)
        failArgument(kOption, text, fmt::format("has a wrong value, expected {}", paramRange(param)));
    return *number;
}

}  // namespace

const EstimatorInfo& estimatorArgument(std::string_view id) {
    if (const EstimatorInfo* info = findEstimator(id)) return *info;
    std::vector<std::string_view> ids;
    for (const EstimatorInfo* info : estimators()) ids.push_back(info->id);
    ids.push_back(kAutomaticEstimator);
    failArgument("--estimator", id, fmt::format("is unknown, {}", expectedOneOf(id, ids)));
}

ParamValues paramArguments(const EstimatorInfo& info, const std::vector<std::string>& texts) {
    ParamValues values = initialValues(info);
    std::vector<bool> given(values.size());
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            failArgument(kOption, text, "is no parameter, expected NAME=VALUE");
        const std::size_t place = paramOfName(info, text, text.substr(0, equals));
        if (given[place]) failArgument(kOption, text, "is given twice, expected one value");
        given[place] = true;
        values[place] = valueOf(info.params[place], text, text.substr(equals + 1));
    }
    return values;
}

std::string paramText(const ParamInfo& param, double value) {
    if (!param.choices.empty()) return std::string(param.choices[static_cast<std::size_t>(value)]);
    return param.whole ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
}

std::string describedEstimators() {
    std::string lines;
    for (const EstimatorInfo* info : estimators())
        lines += fmt::format("  {:<15} {}\n", info->id, info->meaning);
    return lines + fmt::format("  {:<15} what the scene requires: halfdisk requirements tells it\n",
                               kAutomaticEstimator);
}

}  // namespace halfdisk
