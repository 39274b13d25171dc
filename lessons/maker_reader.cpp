#include "lessons/maker_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/value_reader.h"

namespace halfdisk {
namespace {

template <class Table>
const auto& findNamed(const std::string& file, TextPosition where, std::string_view what,
                      std::string_view name, const Table& table, const auto& nameOfEntry) {
    std::vector<std::string_view> names;
    for (const auto& entry : table) {
        if (nameOfEntry(entry) == name) return entry;
        names.push_back(nameOfEntry(entry));
    }
    failAt(file, where,
           fmt::format("{} \"{}\" is unknown, {}", what, excerpt(name), expectedOneOf(name, names)));
}

double readParam(const std::string& file, const TomlEntry& entry, const ParamInfo& param) {
    const TomlValue& value = entry.value;
    const auto fail = [&] {
        failAt(file, value.where,
               fmt::format("\"{}\" has a wrong value, expected {}", param.name, paramRange(param)));
    };
    if (!param.choices.empty()) {
        const auto* name = std::get_if<std::string>(&value.data);
        const auto found =
            name ? std::find(param.choices.begin(), param.choices.end(), *name) : param.choices.end();
        if (found == param.choices.end()) fail();
        return static_cast<double>(found - param.choices.begin());
    }
    const double number = readNumber(file, entry.key, value, {param.least, param.most, paramRange(param)});
    if (param.whole && number != std::floor(number)) fail();
    return number;
}

void readParams(const std::string& file, const TomlValue& value, Maker& maker) {
    const EstimatorInfo& info = *findEstimator(maker.estimator);
    for (const TomlEntry& entry : readTable(file, "params", value).entries) {
        const auto& param = findNamed(file, entry.value.where, fmt::format("parameter of {}", info.id),
                                      entry.key, info.params, [](const ParamInfo& p) { return p.name; });
        maker.params[static_cast<std::size_t>(&param - info.params.data())] = readParam(file, entry, param);
    }
}

}  // namespace

void readMaker(TableReader& table, std::optional<Maker>& maker) {
    const std::string& file = table.file();
    constexpr TextRule kIdRule{100, false, false};
    if (const TomlValue* id = table.optional("estimator")) {
        const std::string name = readText(file, "estimator", *id, kIdRule);
        const EstimatorInfo& info = *findNamed(file, id->where, "estimator", name, estimators(),
                                               [](const EstimatorInfo* e) { return e->id; });
        maker = makerOf(info.id);
    }
    if (const TomlValue* params = table.optional("params")) {
        if (!maker) failAt(file, params->where, "\"params\" need an \"estimator\" that they belong to");
        readParams(file, *params, *maker);
    }
    if (const TomlValue* specular = table.optional(kMaxSpecularInfo.name)) {
        if (!maker) failAt(file, specular->where, "\"specular\" needs an \"estimator\" that it belongs to");
        maker->specular = static_cast<std::uint32_t>(readWhole(
            file, kMaxSpecularInfo.name, *specular, {kMaxSpecularInfo.least, kMaxSpecularInfo.most}));
    }
}

void readMakers(TableReader& table, Makers& makers) {
    readMaker(table, makers.first);
    const TomlValue* against = table.optional("against");
    if (against == nullptr) return;
    const std::string& file = table.file();
    TableReader other(file, readTable(file, "against", *against), against->where, "\"against\"");
    readMaker(other, makers.second);
    const TomlValue* depth = other.optional(kMaxDepthInfo.name);
    if (const TomlValue* equal = other.optional("equal"))
        makers.equal = readNamed(file, "equal", *equal, kBudgets);
    other.finish();
    if (!makers.second) failAt(file, against->where, "\"against\" has no \"estimator\"");
    if (!makers.first)
        failAt(file, against->where, "\"against\" needs an \"estimator\" that it stands beside");
    if (depth != nullptr)
        makers.second->depth = static_cast<std::uint32_t>(
            readWhole(file, kMaxDepthInfo.name, *depth, {kMaxDepthInfo.least, kMostMakerDepth}));
}

std::string paramRange(const ParamInfo& param) {
    if (!param.choices.empty()) return fmt::format("one of {}", fmt::join(param.choices, ", "));
    const std::string range =
        fmt::format("a {}number from {:g} to {:g}", param.whole ? "whole " : "", param.least, param.most);
    return param.unit.empty() ? range : fmt::format("{} {}", range, param.unit);
}

}  // namespace halfdisk
