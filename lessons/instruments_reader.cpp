#include "lessons/instruments_reader.h"

#include <fmt/format.h>

#include "lessons/value_reader.h"

namespace halfdisk {
namespace {

/// Replaces `field` if the table has the key.
void readRange(TableReader& table, std::string_view key, double least, double most, double& field) {
    const TomlValue* value = table.optional(key);
    if (!value) return;
    const std::string expected = fmt::format("a number from {} to {}", least, most);
    field = readNumber(table.file(), key, *value, {least, most, expected});
}

std::uint32_t readForcedValue(const std::string& file, const RequirementInfo& info, const TomlValue& value) {
    if (const auto* on = std::get_if<bool>(&value.data)) {
        if (info.kind == Switch::onOff || !*on) return *on ? 1 : 0;
    }
    if (info.kind == Switch::number)
        return static_cast<std::uint32_t>(readWhole(file, info.name, value, {0, kMaxDepthInfo.most}));
    failAt(file, value.where, fmt::format("\"{}\" is no switch, expected true or false", info.name));
}

}  // namespace

const RequirementInfo* findSwitch(std::string_view name, std::string& fault) {
    std::vector<std::string_view> names;
    for (const RequirementInfo& info : kRequirements) {
        if (info.kind != Switch::none) names.push_back(info.name);
        if (info.name != name) continue;
        if (info.kind != Switch::none) return &info;
        fault = fmt::format("can't be switched: {}", info.fixed);
        return nullptr;
    }
    fault = fmt::format("names no requirement, {}", expectedOneOf(name, names));
    return nullptr;
}

void readForced(const std::string& file, const TomlValue& value, std::vector<Forced>& forced) {
    forced.clear();
    for (const TomlEntry& entry : readTable(file, "force", value).entries) {
        std::string fault;
        const RequirementInfo* info = findSwitch(entry.key, fault);
        if (!info) failAt(file, entry.value.where, fmt::format("\"{}\" {}", entry.key, fault));
        forced.push_back({info->id, readForcedValue(file, *info, entry.value)});
    }
}

void readDial(const std::string& file, const TomlValue& value, DialSetting& dial) {
    TableReader table(file, readTable(file, "dial", value), value.where, "\"dial\"");
    readRange(table, "scale", kLeastScale, kMostScale, dial.scale);
    readRange(table, "offset", 0.0, kMostOffset, dial.offset);
    readRange(table, "gap", 0.0, kMostGap, dial.gap);
    readRange(table, "epsilon", kLeastEpsilon, kMostEpsilon, dial.fixedEpsilon);
    if (const TomlValue* precision = table.optional("precision"))
        dial.precision = readNamed(file, "precision", *precision, kPrecisions);
    if (const TomlValue* policy = table.optional("policy"))
        dial.policy = readNamed(file, "policy", *policy, kEpsilonPolicies);
    table.finish();
}

void readInstruments(TableReader& table, InstrumentSettings& settings) {
    if (const TomlValue* dial = table.optional("dial")) readDial(table.file(), *dial, settings.dial);
    readRange(table, "tolerance", kLeastTolerance, kMostTolerance, settings.tolerance);
    if (const TomlValue* forced = table.optional("force")) readForced(table.file(), *forced, settings.forced);
    if (table.has("wishedError")) settings.wish = Wish::error;
    if (table.has("wishedMilliseconds")) settings.wish = Wish::time;
    readRange(table, "wishedError", kLeastWishedError, kMostWishedError, settings.wishedError);
    readRange(table, "wishedMilliseconds", kLeastMilliseconds, kMostMilliseconds,
              settings.wishedMilliseconds);
    if (table.has("wishedMilliseconds")) settings.tradeCost = TradeCost::seconds;
    if (const TomlValue* cost = table.optional("tradeCost"))
        settings.tradeCost = readNamed(table.file(), "tradeCost", *cost, kTradeCosts);
}

}  // namespace halfdisk
