#include "core/requirements/specular_findings.h"

#include <algorithm>
#include <cmath>

#include "core/requirements/series.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

constexpr auto kUsual = static_cast<std::uint32_t>(kMaxSpecularInfo.initial);
constexpr auto kMost = static_cast<std::uint32_t>(kMaxSpecularInfo.most);

/// By geometry, or by what mirrors swallow; the usual number, and more where mirrors are so bright that this
/// would be seen. Nothing: what is inside glass, or between perfect mirrors, may go on for ever.
std::optional<std::uint32_t> bound(const SceneFacts& facts, double tolerance) {
    if (facts.longestChain) return *facts.longestChain;
    if (facts.glass > 0 || facts.mostReflectance >= 1.0) return std::nullopt;
    if (facts.mostReflectance <= 0.0) return kUsual;
    const double events = std::ceil(std::log(tolerance) / std::log(facts.mostReflectance));
    if (events > kMost) return std::nullopt;
    return std::max(kUsual, static_cast<std::uint32_t>(events));
}

}  // namespace

// Fewer than the usual number are never taken: long chains are rare and bright, and few paths would not show
// what they bring.
SpecularFindings findSpecular(const RequirementsQuestion& question, const SceneFacts& facts,
                              std::uint64_t& rays) {
    SpecularFindings found;
    if (const auto least = bound(facts, question.tolerance)) {
        found.required = *least;
        return found;
    }
    found.required = kUsual;
    const auto series = seriesOf(question, kUsual);
    if (!series || !(facts.traits.delta || facts.traits.area)) return found;
    const Problem problem{
        .index = question.index, .sensor = question.sensor, .seed = question.seed, .stop = question.stop};
    const auto run = [&](std::uint32_t events, const PilotLimits& limits) {
        Plan plan = series->plan;
        plan.maxSpecular = events;
        Pilot result = pilot(problem, plan, limits);
        rays += result.rays;
        return result;
    };
    const Pilot usual =
        run(kUsual, {.rays = static_cast<std::uint64_t>(question.effort * kSeriesRays), .leastPasses = 16});
    if (usual.cut == 0) {
        found.measured.push_back({kUsual, 0.0, 0.0});
        return found;
    }
    const PilotLimits same{.rays = 0, .leastPasses = usual.passes, .mostPasses = usual.passes};
    const Pilot all = run(kMost, same);
    for (std::uint32_t events = kUsual; events < kMost; events *= 2) {
        found.measured.push_back(shareBeyond(events, all, events == kUsual ? usual : run(events, same)));
        found.required = events;
        // The other half is for bounces.
        if (isEnough(found.measured.back(), question.tolerance / 2.0)) return found;
    }
    found.required = kMost;
    return found;
}

double specularShare(const SpecularFindings& specular, double tolerance) {
    return specular.measured.empty() ? 0.0 : std::min(tolerance / 2.0, mayMiss(specular.measured.back()));
}

std::string specularReason(const RequirementsAnswer& answer) {
    const SceneFacts& facts = answer.facts;
    if (!facts.traits.specular) return words::joined(facts.chainReason, ": nothing to follow");
    std::string reason;
    if (facts.mirrors > 0) reason += words::counted(facts.mirrors, "mirror");
    if (facts.mirrors > 0 && facts.glass > 0) reason += ", ";
    if (facts.glass > 0) reason += words::joined(words::counted(facts.glass, "wall"), " of glass");
    reason += words::joined("; ", facts.chainReason);
    if (!answer.specular.measured.empty()) {
        const BeyondDepth& beyond = answer.specular.measured.back();
        reason += words::joined(": more than ", std::to_string(beyond.depth), " events bring ",
                                shareWords(beyond, answer.tolerance));
        if (!isEnough(beyond, answer.tolerance))
            reason += words::joined(", and no more than ", std::to_string(answer.specular.required),
                                    " are followed: some light is missing");
    }
    std::uint64_t cut = 0, paths = 0;
    for (const Candidate& candidate : answer.candidates)
        if (candidate.chosen) {
            cut = candidate.pilot.cut;
            paths = candidate.pilot.paths;
        }
    return words::joined(reason, "; ", std::to_string(cut), " of ", std::to_string(paths),
                         " paths tried were longer");
}

}  // namespace halfdisk
