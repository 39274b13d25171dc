#include "lessons/claim_reader.h"

#include "lessons/instruments_reader.h"
#include "lessons/step_values_reader.h"

namespace halfdisk {
namespace {

constexpr TextRule kSentenceRule{500, false, false};
constexpr TextRule kIdRule{100, false, false};
constexpr NumberRule kNumberRule{-1e300, 1e300, "a finite number"};
constexpr NumberRule kToleranceRule{0.0, 1e300, "a number from 0 on"};
constexpr WholeRule kRepeatsRule{1, 1'000'000};
constexpr StepLimits kTrialLimits{10'000'000, 1000};
constexpr std::size_t kMostParams = 100;

/// `gather = 100` as the command line has it: gather=100.
std::string paramText(const std::string& file, const TomlEntry& entry) {
    const TomlValue& value = entry.value;
    if (const auto* text = std::get_if<std::string>(&value.data))
        return fmt::format("{}={}", entry.key, *text);
    if (const auto* whole = std::get_if<std::int64_t>(&value.data))
        return fmt::format("{}={}", entry.key, *whole);
    return fmt::format("{}={}", entry.key, readNumber(file, entry.key, value, kNumberRule));
}

/// Replaces what the inline table says.
void readTrial(const std::string& file, std::string_view key, const TomlValue& value, const Scene& scene,
               Trial& trial) {
    TableReader table(file, readTable(file, key, value), value.where, fmt::format("\"{}\" of a claim", key));
    readSettings(table, scene, kTrialLimits, trial.settings, trial.at);
    if (const TomlValue* specular = table.optional(kMaxSpecularInfo.name))
        trial.settings.maxSpecular = static_cast<std::uint32_t>(readWhole(
            file, kMaxSpecularInfo.name, *specular, {kMaxSpecularInfo.least, kMaxSpecularInfo.most}));
    if (const TomlValue* estimator = table.optional("estimator"))
        trial.estimator = readText(file, "estimator", *estimator, kIdRule);
    if (const TomlValue* repeats = table.optional("repeats"))
        trial.repeats = readWhole(file, "repeats", *repeats, kRepeatsRule);
    if (const TomlValue* pixel = table.optional("pixel"))
        trial.pixel = static_cast<std::uint32_t>(readWhole(file, "pixel", *pixel, {0, kEyeStripPixels - 1}));
    if (const TomlValue* picture = table.optional("picture"))
        trial.picture = readNamed(file, "picture", *picture, kClaimPictures);
    readInstruments(table, trial.instruments);
    if (const TomlValue* params = table.optional("params")) {
        trial.params.clear();
        const TomlTable& entries = readTable(file, "params", *params);
        if (entries.entries.size() > kMostParams)
            failAt(file, params->where, "\"params\" has too many parameters");
        for (const TomlEntry& entry : entries.entries) trial.params.push_back(paramText(file, entry));
    }
    table.finish();
}

std::string relationNames() {
    std::string names;
    for (const auto& relation : kRelations)
        names += (names.empty() ? "\"" : ", \"") + std::string(relation.name) + "\"";
    return names;
}

}  // namespace

Claim readClaim(const LessonText& text, const TomlValue& value, const Scene& scene, const StepValues& step) {
    const std::string& file = text.file;
    TableReader table(file, readTable(file, "claim", value), value.where, "[[step.claim]]");
    const TomlValue* name = table.optional("name");
    const TomlValue* says = table.required("says");
    const TomlValue* quantity = table.required("measure");
    const TomlValue* with = table.optional("with");
    const TomlValue* over = table.optional("over");
    const TomlValue* tolerance = table.optional("tolerance");
    const TomlValue* number = nullptr;
    Claim claim;
    for (const auto& relation : kRelations)
        if (const TomlValue* found = table.optional(relation.name)) {
            if (number != nullptr)
                failAt(file, found->where,
                       fmt::format("a claim has two numbers, expected one of {}", relationNames()));
            number = found;
            claim.relation = relation.value;
        }
    table.finish();
    if (number == nullptr)
        failAt(file, value.where,
               fmt::format("the claim has no number, expected one of {}", relationNames()));

    if (name != nullptr) claim.name = readClaimName(file, *name);
    claim.says = readWords(text, "says", *says, kSentenceRule);
    claim.quantity = readNamed(file, "measure", *quantity, kQuantities);
    claim.number = readNumber(file, nameOf(kRelations, claim.relation), *number, kNumberRule);
    claim.where = number->where;
    if (tolerance != nullptr) {
        if (claim.relation != Relation::equals)
            failAt(file, tolerance->where, "only \"equals\" has a \"tolerance\"");
        claim.tolerance = readNumber(file, "tolerance", *tolerance, kToleranceRule);
    }
    claim.of.settings = step.settings;
    claim.of.at = step.at;
    claim.of.pixel = step.pixel;
    claim.of.instruments = step.instruments;
    if (with != nullptr) readTrial(file, "with", *with, scene, claim.of);
    if (over != nullptr) readTrial(file, "over", *over, scene, claim.over.emplace(claim.of));
    return claim;
}

}  // namespace halfdisk
