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

}  // namespace

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
