// What does the advisor say: the plan in a sentence, each requirement with its reason, and what it costs?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/app_state.h"

namespace halfdisk {

/// With what is forced; while that is not known, or refused, what the scene needs by itself. Null: neither.
const RequirementsAnswer* knownRequirements(const AppState& state);
/// English.
std::string_view groundWord(Ground ground);

/// Nothing: as the scene needs it.
std::optional<std::uint32_t> forcedValue(const InstrumentSettings& settings, RequirementId id);
/// In the order of the table, each once.
void force(InstrumentSettings& settings, RequirementId id, std::optional<std::uint32_t> value);

/// A requirement as it is shown, in the window's language.
struct RequirementLine {
    RequirementId id{};
    std::string title;
    std::string value;  ///< `needed`, `2 needed`, `forced: off`
    bool on = false, forced = false;
    std::string reason;                    ///< after its ground: `proof: no mirror and no glass`
    std::vector<std::string> costs;        ///< `without it: light -12 % (± 1 %), rays × 1.3`
    std::vector<std::string> costsByTime;  ///< the same with time, which no two machines agree in
};
/// All of the table, first those that can be forced. Empty: nothing is known yet.
std::vector<RequirementLine> requirementLines(const AppState& state);

/// `Follow paths back from the wall and ask a light at every wall: at most 2 scatterings.` Or why there is
/// no such sentence.
std::string advice(const AppState& state);
/// What the plan leaves out or can't carry; empty: nothing that is known.
std::string adviceLacks(const AppState& state);
/// What is forced costs, beside what the scene needs; empty: nothing is forced, or it is not measured yet.
std::string forcedWords(const AppState& state);
/// The plan beside a program that leaves nothing out; empty: not measured yet.
std::string everythingWords(const AppState& state);

/// That makes pictures as the plan says; none: there is no plan, or no light.
std::optional<Maker> plannedMaker(const AppState& state);
/// `path, emitters = sample, roulette = 0; depth 2, ...`
std::string plannedMakerWords(const AppState& state);

std::string requirementsWords(const AppState& state);
/// CSV: see plot_tables.h. A row for each change that was measured, or for the requirement alone.
std::string requirementsTable(const AppState& state);

}  // namespace halfdisk
