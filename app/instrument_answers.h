// What did the instruments find? Plain data that grows behind the frame.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/extremes/dial.h"
#include "core/requirements/costs.h"
#include "core/trade/trade_choice.h"
#include "lessons/instruments.h"

namespace halfdisk {

/// What the dial asks for.
inline TradeWish wishOf(const InstrumentSettings& settings) {
    if (settings.wish == Wish::error) return {settings.tradeCost, settings.wishedError, 0.0};
    return {TradeCost::seconds, std::nullopt, settings.wishedMilliseconds / 1000.0};
}

/// What the dial chose, done again with other seeds.
struct TradeCheck {
    TradeChoice choice;
    std::optional<TradeOutcome> outcome{};  ///< none: it would take too long

    bool answers(const TradeChoice& asked) const {
        return choice.cell == asked.cell && choice.passes == asked.passes;
    }
};

/// The trade as far as it is measured.
struct TradeSoFar {
    TradeReport report;
    std::string reference;  ///< in words
    std::string refusal;    ///< not empty: why there is none
    std::size_t settings = 0;
    std::size_t done = 0;               ///< of them
    std::optional<TradeCheck> check{};  ///< of a wish that may be older than the window's
    bool complete() const { return done == settings; }
};

/// The scene as the dial places it, by the chosen tracer and by the product itself.
struct DialAnswer {
    DialSetting setting;
    ExtremeCounts chosen, product;
    std::vector<Segment> slit{};  ///< the walls that its gap puts into the scene
    std::string refusal;          ///< not empty: why nothing was counted
};

struct InstrumentAnswers {
    std::shared_ptr<const DialAnswer> dial;                  ///< null: not wanted, or not begun
    std::shared_ptr<const TradeSoFar> trade;                 ///< the same
    std::shared_ptr<const RequirementsAnswer> requirements;  ///< the same, or refused
    std::shared_ptr<const RequirementsAnswer> unforced;      ///< with nothing forced: what the scene needs
    std::string requirementsRefusal;
    std::shared_ptr<const PlanCost> forcedCost;  ///< of what is forced, beside what the scene needs
    std::shared_ptr<const Costs> costs;          ///< grows row by row
};

}  // namespace halfdisk
