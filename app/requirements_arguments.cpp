#include "app/requirements_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli_arguments.h"
#include "app/interruption.h"
#include "app/progress_bar.h"
#include "core/stopwatch.h"
#include "lessons/instruments_reader.h"

namespace halfdisk {
namespace {

constexpr std::string_view kOption = "--force";
constexpr std::string_view kStopping = "stopping; Ctrl-C again ends at once";

const RequirementInfo& infoOfName(std::string_view text, std::string_view name) {
    std::string fault;
    const RequirementInfo* info = findSwitch(name, fault);
    if (!info) failArgument(kOption, text, fault);
    return *info;
}

std::uint32_t valueOf(const RequirementInfo& info, std::string_view text, std::string_view value) {
    if (value == "off") return 0;
    if (info.kind == Switch::onOff) {
        if (value == "on") return 1;
        failArgument(kOption, text, "has a wrong value, expected on or off");
    }
    const auto count = parseWhole(value);
    if (!count || *count > kMaxDepthInfo.most)
        failArgument(kOption, text,
                     fmt::format("has a wrong value, expected off or a whole number from 0 to {}",
                                 kMaxDepthInfo.most));
    return static_cast<std::uint32_t>(*count);
}

/// `mis=on, bounces=2`
std::string forcedWords(const std::vector<Forced>& forced) {
    std::string words;
    for (const Forced& one : forced) {
        const RequirementInfo& info = infoOf(one.id);
        const std::string value =
            info.kind == Switch::onOff ? (one.value != 0 ? "on" : "off") : std::to_string(one.value);
        words += fmt::format("{}{}={}", words.empty() ? "" : ", ", info.name, value);
    }
    return words;
}

}  // namespace

std::vector<Forced> forcedArguments(const std::vector<std::string>& texts) {
    std::vector<Forced> all;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            failArgument(kOption, text, "is nothing to force, expected NAME=on, NAME=off or NAME=NUMBER");
        const RequirementInfo& info = infoOfName(text, std::string_view(text).substr(0, equals));
        for (const Forced& forced : all)
            if (forced.id == info.id) failArgument(kOption, text, "is given twice, expected one value");
        all.push_back({info.id, valueOf(info, text, std::string_view(text).substr(equals + 1))});
    }
    return all;
}

double toleranceArgument(const std::string& text) {
    return numberArgument("--tolerance", text, kLeastTolerance, kMostTolerance);
}

std::string describedSwitches() {
    std::string lines;
    for (const RequirementInfo& info : kRequirements)
        if (info.kind != Switch::none)
            lines += fmt::format("  {:<15} {} ({})\n", info.name, info.asks,
                                 info.kind == Switch::onOff ? "on, off" : "off or a number");
    return lines;
}

IndexMethod PlanRequest::indexMethod() const {
    for (const Forced& one : forced)
        if (one.id == RequirementId::index)
            return one.value != 0 ? IndexMethod::tree : IndexMethod::bruteForce;
    return IndexMethod::automatic;
}

void addPlanOptions(CLI::App& command, PlanTexts& texts) {
    command
        .add_option("--tolerance", texts.tolerance,
                    fmt::format("of --estimator auto: share of the light that may be missing or noise [{}]",
                                kInitialTolerance))
        ->type_name("SHARE");
    command
        .add_option(
            "--force", texts.force,
            "of --estimator auto: a requirement as you want it; may be repeated (see halfdisk requirements)")
        ->type_name("NAME=on|off|NUMBER")
        ->allow_extra_args(false);
    command.add_flag("--explain", texts.explain, "tell what the scene requires, and why");
}

PlanRequest planRequest(const PlanTexts& texts, std::string_view estimator,
                        const std::vector<std::string>& params, std::uint32_t depth, std::uint32_t specular) {
    PlanRequest request;
    request.automatic = estimator == kAutomatic;
    request.explain = texts.explain;
    if (!request.automatic && !texts.force.empty())
        throw InputError(
            "--force is for --estimator auto: any other one is told by --param, expected --estimator auto");
    if (!request.asks() && texts.tolerance)
        throw InputError("--tolerance is for --estimator auto and --explain, expected one of them");
    if (request.automatic && !params.empty())
        failArgument("--param", params.front(),
                     "is not for auto, which chooses the parameters, expected --force");
    if (texts.tolerance) request.tolerance = toleranceArgument(*texts.tolerance);
    request.forced = forcedArguments(texts.force);
    const auto add = [&](RequirementId id, std::uint32_t value, std::string_view option) {
        for (const Forced& forced : request.forced)
            if (forced.id == id)
                throw InputError(fmt::format("{} and --force {} exclude each other, expected one of them",
                                             option, infoOf(id).name));
        request.forced.push_back({id, value});
    };
    if (texts.depthGiven) add(RequirementId::bounces, depth, "--depth");
    if (texts.specularGiven) add(RequirementId::specular, specular, "--specular");
    return request;
}

bool askRequirements(RequirementsQuestion question, RequirementsAnswer& answer) {
    ProgressBar bar;
    const Interruption interruption([&bar] { bar.say(kStopping); });
    const Stopwatch watch;
    question.stop = [&interruption] { return interruption.asked(); };
    question.told = [&](double share, std::string_view what) { bar.tell(share, watch.seconds(), what); };
    try {
        findRequirements(question, answer);
        return true;
    } catch (const Stopped&) {
        return false;
    } catch (const NoWay& refusal) {
        throw InputError(
            fmt::format("{} ({}), expected other ones", refusal.what(), forcedWords(question.forced)));
    } catch (const std::invalid_argument& refusal) {
        throw InputError(refusal.what());
    }
}

Costs costsAsked(RequirementsQuestion question, const RequirementsAnswer& answer, const CostLimits& limits) {
    ProgressBar bar;
    const Interruption interruption([&bar] { bar.say(kStopping); });
    const Stopwatch watch;
    question.stop = [&interruption] { return interruption.asked(); };
    Costs costs;
    bar.tell(0.0, 0.0, "costs");
    try {
        while (measureNextCost(question, answer, limits, costs))
            bar.tell(static_cast<double>(costs.done) / static_cast<double>(costs.pieces), watch.seconds(),
                     fmt::format("{} of {} costs", costs.done, costs.pieces));
    } catch (const Stopped&) {
        // What is measured stays.
    }
    return costs;
}

std::optional<RequirementsAnswer> requirementsAsked(const PlanRequest& request, const SegmentIndex& index,
                                                    const Sensor& sensor, std::uint64_t seed) {
    RequirementsAnswer answer;
    if (!askRequirements({index, sensor, request.tolerance, request.forced, seed}, answer))
        return std::nullopt;
    return answer;
}

}  // namespace halfdisk
