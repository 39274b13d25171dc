#include "lessons/claim_reader.h"

#include "core/estimators/all.h"
#include "lessons/claim_keys.h"
#include "lessons/instruments_reader.h"
#include "lessons/maker_reader.h"
#include "lessons/step_values_reader.h"

namespace halfdisk {
namespace {

constexpr TextRule kSentenceRule{500, false, false};
constexpr NumberRule kNumberRule{-1e300, 1e300, "a finite number"};
constexpr NumberRule kToleranceRule{0.0, 1e300, "a number from 0 on"};
constexpr WholeRule kRepeatsRule{1, 1'000'000};
constexpr StepLimits kTrialLimits{10'000'000, 1000};

/// Throws InputError for a key that means nothing for what is measured.
void checkKeys(const TableReader& table, Quantity quantity) {
    for (const ClaimKey& key : kClaimKeys) {
        if (!table.has(key.name) || key.isFor(quantity)) continue;
        std::string quantities;
        for (const auto& other : kQuantities)
            if (key.isFor(other.value))
                quantities += fmt::format("{}\"{}\"", quantities.empty() ? "" : ", ", other.name);
        failAt(table.file(), table.at(key.name).where,
               fmt::format("\"{}\" means nothing where \"{}\" is measured, {}", key.name,
                           nameOf(kQuantities, quantity),
                           quantities.empty() ? "nor in any claim: expected \"wishedError\""
                                              : "expected it with one of " + quantities));
    }
}

/// Parameters that are named replace all that were named before.
void readTrialMaker(TableReader& table, Quantity quantity, Maker& maker) {
    std::optional<Maker> read = table.has("params") ? makerOf(maker.estimator) : maker;
    readMaker(table, read);
    maker = *read;
    if (table.has("params") && isSampledAtPoint(quantity) && maker.estimator == kCastRayEstimator.id)
        failAt(table.file(), table.at("params").where,
               "\"params\" are not for cast-ray at P, expected its keys \"samples\", \"sampler\" and "
               "\"emitters\" beside them");
}

/// Replaces what the inline table says.
void readTrial(const std::string& file, std::string_view key, const TomlValue& value, const Scene& scene,
               Quantity quantity, Trial& trial) {
    TableReader table(file, readTable(file, key, value), value.where, fmt::format("\"{}\" of a claim", key));
    checkKeys(table, quantity);
    readSettings(table, scene, kTrialLimits, trial.settings, trial.at);
    readTrialMaker(table, quantity, trial.maker);
    trial.settings.maxSpecular = trial.maker.specular.value_or(trial.settings.maxSpecular);
    if (const TomlValue* repeats = table.optional("repeats"))
        trial.repeats = readWhole(file, "repeats", *repeats, kRepeatsRule);
    if (const TomlValue* pixel = table.optional("pixel"))
        trial.pixel = static_cast<std::uint32_t>(readWhole(file, "pixel", *pixel, {0, kEyeStripPixels - 1}));
    if (const TomlValue* picture = table.optional("picture"))
        trial.picture = readNamed(file, "picture", *picture, kClaimPictures);
    readInstruments(table, trial.instruments);
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
    if (with != nullptr) readTrial(file, "with", *with, scene, claim.quantity, claim.of);
    if (over != nullptr) readTrial(file, "over", *over, scene, claim.quantity, claim.over.emplace(claim.of));
    return claim;
}

}  // namespace halfdisk
