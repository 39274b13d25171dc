#include "app/requirements_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli_arguments.h"

namespace halfdisk {
namespace {

constexpr std::string_view kOption = "--force";

const RequirementInfo& infoOfName(std::string_view text, std::string_view name) {
    std::vector<std::string_view> names;
    for (const RequirementInfo& info : kRequirements) {
        if (info.name == name && info.kind == Switch::none)
            failArgument(kOption, text, fmt::format("can't be switched: {}", info.fixed));
        if (info.name == name) return info;
        if (info.kind != Switch::none) names.push_back(info.name);
    }
    failArgument(kOption, text, fmt::format("names no requirement, {}", expectedOneOf(name, names)));
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

RequirementsAnswer requirementsAsked(const RequirementsQuestion& question) {
    try {
        return requirementsOf(question);
    } catch (const std::invalid_argument& refusal) {
        throw InputError(refusal.what());
    }
}

}  // namespace halfdisk
