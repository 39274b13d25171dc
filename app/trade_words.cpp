// What does the trade tell, in words? What was chosen and why, what then happened, and how each setting
// stands.
#include "app/trade_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/language.h"
#include "app/message_words.h"

namespace halfdisk {
namespace {

/// `3.4 %`, `120 %`.
std::string percentWords(double share) {
    return share < 0.995 ? say("{:.2g} %", 100.0 * share) : say("{:.0f} %", 100.0 * share);
}

std::string raysWords(double rays) {
    if (rays < 0.5) return std::string(tr("no rays"));
    return rays < 1e5 ? say("{:.0f} rays", rays) : say("{:.2g} million rays", rays / 1e6);
}

std::string timeWords(double seconds) {
    return seconds < 0.9995 ? say("{:.2g} ms", 1e3 * seconds) : say("{:.2g} s", seconds);
}

/// `3.1 times`: of what is dearer, or errs more.
std::string timesWords(double factor) {
    if (!std::isfinite(factor)) return std::string("\u221e");
    constexpr double kManyDigits = 1e6;
    const bool few = factor < 99.5 || factor > kManyDigits;
    return local(few ? fmt::format("{:.2g}", factor) : fmt::format("{:.0f}", factor));
}

double askedOf(const TradeReport& report, std::size_t cell) {
    return report.verdicts[cell].off[0].value_or(2.0);
}

std::string biasSentence(const TradeVerdict& verdict) {
    if (verdict.biased)
        return say("Bias: {} (95 %: {} to {}), which no rays mend.", percentWords(verdict.bias),
                   percentWords(verdict.biasLow), percentWords(verdict.biasHigh));
    return say("No bias is seen; it would be below {}.", percentWords(verdict.biasHigh));
}

/// Errors for which a cell is the cheapest, by that cost.
std::string stretchWords(const TradeReport& report, std::size_t cell, const Named<TradeCost>& cost) {
    std::string words;
    for (const TradeStretch& stretch : report.fronts[at(cost.value)]) {
        if (stretch.cell != cell) continue;
        words += words.empty() ? "" : ", ";
        words += say("{} to {}", percentWords(stretch.fromError), percentWords(stretch.toError));
    }
    if (words.empty()) return words;
    return cost.value == TradeCost::rays ? say("On the front in rays: the cheapest for {}.", words)
                                         : say("On the front in time: the fastest for {}.", words);
}

std::string standingWords(const TradeReport& report, std::size_t cell) {
    const TradeVerdict& verdict = report.verdicts[cell];
    if (verdict.foundNothing) return std::string(tr("It found no light at all."));
    if (verdict.sameRunAs) return say("It is the same run as {}.", report.cells[*verdict.sameRunAs].name);
    std::string words;
    for (const Named<TradeCost>& cost : kTradeCosts) {
        const std::optional<double>& off = verdict.off[at(cost.value)];
        std::string line = stretchWords(report, cell, cost);
        if (line.empty() && off)
            line = cost.value == TradeCost::rays
                       ? say("Not on the front: at best {} times the rays of the cheapest.", timesWords(*off))
                       : say("At best {} times the time of the fastest.", timesWords(*off));
        if (line.empty() && !off) line = tr("Its bias keeps it from every error that is asked for.");
        if (line.empty()) continue;
        if (words.find(line) == std::string::npos)
            words += fmt::format("{}{}", words.empty() ? "" : "\n", line);
    }
    if (verdict.nobody) words += fmt::format("\n{}", tr("Nobody should choose it."));
    return words;
}

/// Who comes next, and by how much worse it is.
std::string runnerUpWords(const TradeReport& report, const TradeChoice& choice, const TradeWish& wish) {
    if (!choice.runnerUp) return std::string(tr("No other estimator can."));
    const std::string &name = report.cells[*choice.runnerUp].name, times = timesWords(choice.runnerUpFactor);
    if (!wish.relativeError) return say("The next estimator, {}, would err {} times as much.", name, times);
    return wish.cost == TradeCost::rays ? say("The next estimator, {}, takes {} times the rays.", name, times)
                                        : say("The next estimator, {}, takes {} times as long.", name, times);
}

}  // namespace

const TradeSoFar* tradeOf(const AppState& state) {
    return state.answer ? state.answer->instruments.trade.get() : nullptr;
}

std::optional<TradeChoice> choiceOf(const AppState& state, const TradeSoFar& trade) {
    return trade.refusal.empty() ? choose(trade.report, wishOf(state.instruments)) : std::nullopt;
}

const TradeCheck* checkOf(const TradeSoFar& trade, const TradeChoice& choice) {
    return trade.complete() && trade.check && trade.check->answers(choice) ? &*trade.check : nullptr;
}

std::optional<Maker> makerOf(const TradeSetting& setting, std::uint32_t askedDepth,
                             std::optional<std::uint32_t> stageSpecular) {
    if (setting.facets != 1.0 || setting.index != IndexMethod::automatic) return std::nullopt;
    Maker maker{std::string(setting.estimator->id), setting.params, {}, stageSpecular};
    if (setting.maxDepth != askedDepth) maker.depth = setting.maxDepth;
    return maker;
}

std::optional<Maker> makerOf(const AppState& state, const TradeSoFar& trade, std::size_t cell) {
    const auto& stage = state.makers.first;
    return makerOf(trade.report.cells[cell].setting, trade.report.truth.askedDepth,
                   stage ? stage->specular : std::nullopt);
}

std::optional<std::size_t> cellOnStage(const AppState& state, const TradeSoFar& trade) {
    if (!state.makers.first) return std::nullopt;
    for (std::size_t i = 0; i < trade.report.cells.size(); ++i)
        if (makerOf(state, trade, i) == state.makers.first) return i;
    return std::nullopt;
}

std::string tradeProgress(const TradeSoFar& trade) {
    if (!trade.refusal.empty()) return say("Nothing is measured: {}.", trMessage(trade.refusal));
    return trade.complete() ? std::string()
                            : say("Being measured: {} of {} settings.", trade.done, trade.settings);
}

std::string choiceWords(const AppState& state, const TradeSoFar& trade) {
    const TradeWish wish = wishOf(state.instruments);
    const std::optional<TradeChoice> choice = choiceOf(state, trade);
    const std::string wished =
        wish.relativeError ? percentWords(*wish.relativeError) : timeWords(wish.budget);
    if (!choice)
        return wish.relativeError ? say("No setting is known to come down to {} here.", wished)
                                  : say("In {} no setting is ready here.", wished);
    const std::string& name = trade.report.cells[choice->cell].name;
    std::string words;
    if (!wish.relativeError) {
        words = say("The least error in {}: {}, about {}, with {}.", wished, name,
                    percentWords(choice->relativeError), raysWords(choice->rays));
    } else if (wish.cost == TradeCost::rays) {
        words = say("The cheapest for {}: {}, about {}.", wished, name, raysWords(choice->rays));
    } else {
        words = say("The fastest for {}: {}, about {}, with {}.", wished, name, timeWords(choice->seconds),
                    raysWords(choice->rays));
    }
    return fmt::format("{} {}", words, runnerUpWords(trade.report, *choice, wish));
}

std::string truthWords(const TradeSoFar& trade) {
    const TradeTruth& truth = trade.report.truth;
    if (truth.isDark()) return {};
    const std::string known = percentWords(truth.relativeError);
    return truth.exact ? say("Held against the exact light, known to {}.", known)
                       : say("Held against {}; its own error is {}.", trMessage(trade.reference), known);
}

std::string checkWords(const AppState& state, const TradeSoFar& trade) {
    const std::optional<TradeChoice> choice = choiceOf(state, trade);
    if (!choice) return {};
    if (!trade.complete()) return std::string(tr("It is tried when all are measured."));
    const TradeCheck* check = checkOf(trade, *choice);
    if (!check) return std::string(tr("It is being tried."));
    if (!check->outcome) return std::string(tr("It is not tried: that would take too long."));
    const TradeOutcome& outcome = *check->outcome;
    const Uncertain error = outcome.relativeError;
    // Predicted and measured times belong side by side, but rays are the same on every machine.
    const bool byTime = wishOf(state.instruments).cost == TradeCost::seconds;
    std::string words =
        byTime ? say("Tried {} times: error {} \u00b1 {} in {}; predicted {} in {}.", outcome.runs,
                     percentWords(error.value), percentWords(error.error), timeWords(outcome.seconds),
                     percentWords(choice->relativeError), timeWords(choice->seconds))
               : say("Tried {} times: error {} \u00b1 {}, {}; predicted {}.", outcome.runs,
                     percentWords(error.value), percentWords(error.error), raysWords(outcome.rays),
                     percentWords(choice->relativeError));
    const double factor = error.value / choice->relativeError;
    constexpr double kKept = 1.25, kSure = 2.0;
    const bool kept = (factor < kKept && factor > 1.0 / kKept) ||
                      std::abs(error.value - choice->relativeError) < kSure * error.error;
    words += ' ';
    words += kept ? std::string(tr("As predicted."))
                  : say("That is {} times what was predicted.", timesWords(factor));
    return words;
}

std::string cellWords(const TradeReport& report, std::size_t cell) {
    const TradeCell& one = report.cells[cell];
    if (!one.measured()) return fmt::format("{}\n{}", one.name, trMessage(one.refusal));
    const TradeVerdict& verdict = report.verdicts[cell];
    return fmt::format(
        "{}\n{}\n{}\n{}", one.name,
        say("Error {} after {} in {}.", percentWords(verdict.relativeError),
            raysWords(static_cast<double>(one.rays)), timeWords(one.preparationSeconds + one.seconds)),
        biasSentence(verdict), standingWords(report, cell));
}

std::string tradeWords(const AppState& state) {
    const TradeSoFar* trade = tradeOf(state);
    if (!trade) return std::string(tr("It is not known yet."));
    std::string words = tradeProgress(*trade);
    const auto line = [&](const std::string& more) {
        if (!more.empty()) words += fmt::format("{}{}", words.empty() ? "" : "\n", more);
    };
    if (!trade->refusal.empty() || trade->report.cells.empty()) return words;
    line(choiceWords(state, *trade));
    line(checkWords(state, *trade));
    line(truthWords(*trade));
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < trade->report.cells.size(); ++i)
        if (trade->report.cells[i].measured()) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return askedOf(trade->report, a) < askedOf(trade->report, b);
    });
    for (const std::size_t i : order) {
        std::string one = cellWords(trade->report, i);
        one.replace(one.find('\n'), 1, ": ");
        std::replace(one.begin(), one.end(), '\n', ' ');
        line(one);
    }
    return words;
}

}  // namespace halfdisk
