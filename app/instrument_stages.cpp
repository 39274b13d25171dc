#include "app/instrument_stages.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "core/stop.h"

namespace halfdisk {
namespace {

// Of each setting of the trade, and of its reference: some seconds for all of them.
constexpr double kTradeRays = 60'000.0, kReferenceRays = 1'500'000.0;
// Of all runs that check a choice.
constexpr double kCheckRays = 20'000'000.0;
constexpr std::chrono::duration<double> kLongestSetting(4.0);
constexpr std::uint32_t kTradePixels = 48;
constexpr double kTarget = 0.01;
constexpr double kCostRays = 40'000.0;  // of each run that tells what a part costs: a second or two for all

std::optional<std::uint32_t> wallOf(const LightQuestion& asked) {
    return asked.scene->scene.eye ? std::nullopt : std::optional(asked.at.segment);
}

/// Mirrors and skins of glass in a row that the trade follows: as many as the pictures, so that a setting
/// that is put on the stage shows what was measured.
std::uint32_t tradeSpecular(const LightQuestion& asked) {
    const auto& maker = asked.makers.first;
    return maker && maker->specular ? *maker->specular : asked.settings.maxSpecular;
}

/// Throws away what answers another question.
void tidy(const LightQuestion& asked, InstrumentCache& cache) {
    const bool same = cache.scene == asked.scene && cache.seed == asked.settings.seed &&
                      cache.depth == asked.settings.maxDepth && cache.wall == wallOf(asked) &&
                      cache.effort == asked.effort;
    if (!same) {
        cache = {};
        cache.scene = asked.scene;
        cache.seed = asked.settings.seed;
        cache.depth = asked.settings.maxDepth;
        cache.wall = wallOf(asked);
        cache.effort = asked.effort;
    }
    if (cache.specular != tradeSpecular(asked)) {
        cache.specular = tradeSpecular(asked);
        if (traitsOf(asked.scene->scene).specular) {  // else there is nothing to follow
            cache.answers.trade.reset();
            cache.reference.reset();
        }
    }
    const InstrumentSettings& settings = asked.instrumentSettings;
    if (cache.tolerance != settings.tolerance) cache.answers.unforced.reset();
    if (cache.tolerance != settings.tolerance || cache.forced != settings.forced) {
        cache.tolerance = settings.tolerance;
        cache.forced = settings.forced;
        cache.answers.requirements.reset();
        cache.answers.requirementsRefusal.clear();
        cache.answers.forcedCost.reset();
        cache.answers.costs.reset();
    }
    if (cache.answers.dial && !(cache.answers.dial->setting == settings.dial)) cache.answers.dial.reset();
}

void turnDial(const LightQuestion& asked, InstrumentCache& cache, const StopQuestion& stop) {
    auto answer = std::make_shared<DialAnswer>();
    answer->setting = asked.instrumentSettings.dial;
    DialSetting product = answer->setting;
    product.precision = Precision::twice;
    product.policy = EpsilonPolicy::ours;
    const Scene& scene = asked.scene->scene;
    const Scene slit = withSlit(scene, answer->setting.gap);
    answer->slit.assign(slit.segments.begin() + static_cast<std::ptrdiff_t>(scene.segments.size()),
                        slit.segments.end());
    try {
        answer->chosen = measureDial(answer->setting, scene, stop);
        answer->product = measureDial(product, scene, stop);
    } catch (const std::invalid_argument& refused) {
        answer->refusal = refused.what();
    }
    cache.answers.dial = std::move(answer);
}

RequirementsQuestion requirementsQuestion(const LightQuestion& asked, const Sensor& sensor,
                                          const StopQuestion& stop) {
    return {.index = asked.scene->index,
            .sensor = sensor,
            .tolerance = asked.instrumentSettings.tolerance,
            .forced = asked.instrumentSettings.forced,
            .seed = asked.settings.seed,
            .stop = stop,
            .effort = asked.effort};
}

/// First what the scene needs by itself, which is kept: another switch then only chooses another way.
void askRequirements(const LightQuestion& asked, InstrumentCache& cache, const StopQuestion& stop) {
    InstrumentAnswers& answers = cache.answers;
    const Sensor sensor = instrumentSensor(asked);
    const RequirementsQuestion question = requirementsQuestion(asked, sensor, stop);
    try {
        if (!answers.unforced) {
            RequirementsQuestion free = question;
            free.forced.clear();
            answers.unforced = std::make_shared<const RequirementsAnswer>(requirementsOf(free));
        }
        answers.requirements =
            question.forced.empty()
                ? answers.unforced
                : std::make_shared<const RequirementsAnswer>(replanned(question, *answers.unforced));
    } catch (const std::invalid_argument& refused) {
        answers.requirementsRefusal = refused.what();
    }
}

bool lacksRequirements(const LightQuestion& asked, const InstrumentCache& cache) {
    return asked.instruments.has(View::requirements) && !cache.answers.requirements &&
           cache.answers.requirementsRefusal.empty();
}

/// One piece more of what the parts cost. False: all is measured, or there is nothing to measure.
bool goOnWithCosts(const LightQuestion& asked, InstrumentCache& cache, const StopQuestion& stop) {
    InstrumentAnswers& answers = cache.answers;
    if (!answers.requirements || !hasLight(*answers.requirements)) return false;
    const Sensor sensor = instrumentSensor(asked);
    const RequirementsQuestion question = requirementsQuestion(asked, sensor, stop);
    const CostLimits limits{.rays = static_cast<std::uint64_t>(1.0 + asked.effort * kCostRays), .repeats = 3};
    if (!question.forced.empty() && !answers.forcedCost) {
        answers.forcedCost = std::make_shared<const PlanCost>(
            compareCost(question, answers.requirements->plan, answers.unforced->plan, limits));
        return true;
    }
    auto next = answers.costs ? std::make_shared<Costs>(*answers.costs) : std::make_shared<Costs>();
    if (!measureNextCost(question, *answers.requirements, limits, *next)) return false;
    answers.costs = std::move(next);
    return true;
}

/// Of all estimators, at their initial values and with one parameter changed at a time.
std::vector<TradeSetting> settingsOf(const Sensor& sensor, std::uint32_t depth) {
    std::vector<TradeSetting> settings;
    for (const EstimatorInfo* info : estimators())
        if (info->sensors & bitOf(sensor))
            for (TradeSetting& one : defaultSettings(*info, depth)) settings.push_back(std::move(one));
    return settings;
}

/// Of the trade.
Problem problemOf(const LightQuestion& asked, const Sensor& sensor, const StopQuestion& stop) {
    return {.index = asked.scene->index,
            .sensor = sensor,
            .maxDepth = asked.settings.maxDepth,
            .maxSpecular = tradeSpecular(asked),
            .seed = asked.settings.seed,
            .stop = stop};
}

/// A setting whose least number of passes takes too long, as castRay's trees do at great depths, is told as
/// refused. Throws Stopped.
TradeCell measureInTime(const Problem& problem, const TradeSetting& setting, const TradeReference& reference,
                        double effort) {
    const auto start = std::chrono::steady_clock::now();
    const auto most = std::clamp(16.0 * effort, 0.05, 1.0) * kLongestSetting;
    const auto late = [start, most] { return std::chrono::steady_clock::now() - start > most; };
    Problem timed = problem;
    timed.stop = [&] { return late() || (problem.stop && problem.stop()); };
    try {
        return measureCell(timed, setting, problem.maxDepth, reference, {.rays = effort * kTradeRays});
    } catch (const Stopped&) {
        if (problem.stop && problem.stop()) throw;
    }
    TradeCell cell;
    cell.setting = setting;
    cell.name = nameOf(setting, problem.maxDepth);
    cell.refusal = "a few passes take too long at this depth";
    return cell;
}

/// One more setting. False: all are done.
bool goOnTrading(const LightQuestion& asked, InstrumentCache& cache, const StopQuestion& stop) {
    const Sensor sensor = instrumentSensor(asked);
    const std::uint32_t depth = asked.settings.maxDepth;
    const Problem problem = problemOf(asked, sensor, stop);
    auto next = cache.answers.trade ? std::make_shared<TradeSoFar>(*cache.answers.trade)
                                    : std::make_shared<TradeSoFar>();
    const std::vector<TradeSetting> settings = settingsOf(sensor, depth);
    next->settings = settings.size();
    if (next->done >= settings.size()) return false;
    const auto tell = [&] { cache.answers.trade = next; };
    try {
        if (!cache.reference) {
            cache.reference = exactReference(problem);
            if (!cache.reference) cache.reference = longRun(problem, {.rays = asked.effort * kReferenceRays});
        }
        if (!(cache.reference->light() > 0.0))
            throw NoReference("no light arrives here: no error is a share of anything");
    } catch (const NoReference& why) {
        next->refusal = why.what();
        next->done = next->settings;
        tell();
        return true;
    }
    const TradeReference& reference = *cache.reference;
    next->reference = reference.how;
    std::vector<TradeCell> cells = next->report.cells;
    cells.push_back(measureInTime(problem, settings[next->done], reference, asked.effort));
    ++next->done;
    next->report = tradeReport(
        std::move(cells), {reference.light(), reference.relativeError, reference.exact(), depth}, kTarget);
    tell();
    return true;
}

/// How often what was chosen is done again; nothing: even the least that tells an error would take too long.
/// By rays, so that it is the same on every machine; by time only where that is out of all proportion.
std::optional<std::uint64_t> checksOf(const TradeChoice& choice, double effort) {
    constexpr double kLeastRuns = 4.0, kMostRuns = 8.0, kLongest = 20.0;  // s
    const double runs = std::floor(effort * kCheckRays / std::max(choice.rays, 1.0));
    if (runs < kLeastRuns || kLeastRuns * choice.seconds > effort * kLongest) return std::nullopt;
    return static_cast<std::uint64_t>(std::min(runs, kMostRuns));
}

/// Does what the dial chose, if that was not done yet. False: nothing was to be done.
bool checkTrade(const LightQuestion& asked, InstrumentCache& cache, const StopQuestion& stop) {
    const auto& known = cache.answers.trade;
    if (!known || !known->complete() || !known->refusal.empty() || !cache.reference) return false;
    const auto choice = choose(known->report, wishOf(asked.instrumentSettings));
    if (!choice || (known->check && known->check->answers(*choice))) return false;
    auto next = std::make_shared<TradeSoFar>(*known);
    next->check = TradeCheck{*choice};
    if (const auto runs = checksOf(*choice, asked.effort)) {
        const Sensor sensor = instrumentSensor(asked);
        next->check->outcome =
            checkChoice(problemOf(asked, sensor, stop), known->report, *choice, *cache.reference, *runs, 1);
    }
    cache.answers.trade = std::move(next);
    return true;
}

}  // namespace

Sensor instrumentSensor(const LightQuestion& asked) {
    if (const auto& eye = asked.scene->scene.eye) return EyeStrip{*eye, kTradePixels};
    return Profile{{asked.at.segment}, kTradePixels};
}

void recallInstruments(LightAnswer& answer, InstrumentCache& cache) {
    tidy(answer.asked, cache);
    const ViewSet wanted = answer.asked.instruments;
    answer.instruments = {};
    if (wanted.has(View::extremes)) answer.instruments.dial = cache.answers.dial;
    if (wanted.has(View::trade)) answer.instruments.trade = cache.answers.trade;
    if (!wanted.has(View::requirements)) return;
    answer.instruments.requirements = cache.answers.requirements;
    answer.instruments.unforced = cache.answers.unforced;
    answer.instruments.requirementsRefusal = cache.answers.requirementsRefusal;
    answer.instruments.forcedCost = cache.answers.forcedCost;
    answer.instruments.costs = cache.answers.costs;
}

void answerDial(LightAnswer& answer, InstrumentCache& cache, const std::atomic<bool>& cancelled) {
    tidy(answer.asked, cache);
    if (!answer.asked.instruments.has(View::extremes) || cache.answers.dial) return;
    try {
        turnDial(answer.asked, cache, [&cancelled] { return cancelled.load(std::memory_order_relaxed); });
    } catch (const Stopped&) {
        return;
    }
    recallInstruments(answer, cache);
}

void answerRequirements(LightAnswer& answer, InstrumentCache& cache, const std::atomic<bool>& cancelled) {
    tidy(answer.asked, cache);
    if (!lacksRequirements(answer.asked, cache)) return;
    try {
        askRequirements(answer.asked, cache,
                        [&cancelled] { return cancelled.load(std::memory_order_relaxed); });
    } catch (const Stopped&) {
        // What the scene needs by itself is kept, if it was found.
    }
    recallInstruments(answer, cache);
}

void measureInstruments(LightAnswer& answer, InstrumentCache& cache, const std::atomic<bool>& cancelled,
                        const std::function<void()>& publish) {
    const LightQuestion& asked = answer.asked;
    const StopQuestion stop = [&cancelled] { return cancelled.load(std::memory_order_relaxed); };
    const auto tell = [&] {
        recallInstruments(answer, cache);
        publish();
    };
    tidy(asked, cache);
    try {
        if (lacksRequirements(asked, cache)) {
            askRequirements(asked, cache, stop);
            tell();
        }
        while (asked.instruments.has(View::requirements) && !cancelled && goOnWithCosts(asked, cache, stop))
            tell();
        while (asked.instruments.has(View::trade) && !cancelled && goOnTrading(asked, cache, stop)) tell();
        if (asked.instruments.has(View::trade) && !cancelled && checkTrade(asked, cache, stop)) tell();
    } catch (const Stopped&) {
        // A newer question waits; what is whole is kept.
    }
}

}  // namespace halfdisk
