#include "core/requirements/specular_findings.h"

#include <algorithm>
#include <cmath>

#include "core/requirements/series.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

constexpr auto kUsual = static_cast<std::uint32_t>(kMaxSpecularInfo.initial);
constexpr auto kMost = static_cast<std::uint32_t>(kMaxSpecularInfo.most);

/// Events after which mirrors have swallowed so much of what sets out that the tolerance is left; the usual
/// number where that is more, or where they swallow nothing.
std::uint32_t leastOf(const SceneFacts& facts, double tolerance) {
    if (facts.glass > 0 || facts.mostReflectance <= 0.0 || facts.mostReflectance >= 1.0) return kUsual;
    const double events = std::ceil(std::log(tolerance) / std::log(facts.mostReflectance));
    return events > kMost ? kUsual : std::max(kUsual, static_cast<std::uint32_t>(events));
}

/// The same paths, cut after any number of events.
class Chains {
 public:
    Chains(const RequirementsQuestion& question, const Series& series, std::uint32_t events,
           std::uint64_t& rays)
        : problem_{.index = question.index,
                   .sensor = question.sensor,
                   .seed = question.seed,
                   .stop = question.stop},
          plan_(series.plan),
          rays_(rays) {
        const auto most = static_cast<std::uint64_t>(question.effort * series.rays);
        first_ = run(events, {.rays = most, .leastPasses = 16});
    }

    const Pilot& first() const { return first_; }

    Pilot upTo(std::uint32_t events) { return run(events, {.rays = 0, .leastPasses = first_.passes}); }

 private:
    Pilot run(std::uint32_t events, const PilotLimits& limits) {
        plan_.maxSpecular = events;
        Pilot result = pilot(problem_, plan_, limits);
        rays_ += result.rays;
        return result;
    }

    Problem problem_;
    Plan plan_;
    std::uint64_t& rays_;
    Pilot first_;
};

}  // namespace

// Fewer than the usual number are never taken: long chains are rare and bright, and few paths would not show
// what they bring. That mirrors swallow nearly all of a chain's light is no bound for the sensor's, which may
// be made of nothing else: it only says where to begin.
SpecularFindings findSpecular(const RequirementsQuestion& question, const SceneFacts& facts,
                              const std::optional<Series>& series, std::uint64_t& rays) {
    SpecularFindings found;
    if (facts.longestChain && *facts.longestChain <= kMost) {
        found.required = *facts.longestChain;
        return found;
    }
    const std::uint32_t least = leastOf(facts, question.tolerance);
    found.required = least;
    if (facts.glass == 0 && facts.mostReflectance <= 0.0) return found;
    if (!series) return found;
    Chains chains(question, *series, least, rays);
    if (chains.first().cut == 0) {
        found.measured.push_back({least, 0.0, 0.0});
        return found;
    }
    const Pilot all = chains.upTo(kMost);
    const Tail endless = all.cut > 0 ? endlessChains(all, chains.upTo(kMost / 2)) : Tail{};
    for (std::uint32_t events = least;; events = std::min(2 * events, kMost)) {
        found.measured.push_back(shareBeyond(events, all,
                                             events == least   ? chains.first()
                                             : events == kMost ? all
                                                               : chains.upTo(events),
                                             endless));
        found.required = events;
        // The other half is for bounces.
        if (events == kMost || isEnough(found.measured.back(), question.tolerance / 2.0)) return found;
    }
}

Tail endlessChains(const Pilot& all, const Pilot& half) {
    if (half.cut <= all.cut) return {};
    const double further = static_cast<double>(all.cut) / static_cast<double>(half.cut - all.cut);
    const Difference late = differenceOf(all, half);
    return {further * late.mean, further * late.standardError};
}

std::optional<BeyondDepth> beyondEvents(const RequirementsQuestion& question,
                                        const SpecularFindings& specular, const std::optional<Series>& series,
                                        std::uint32_t events, std::uint64_t& rays) {
    if (events >= specular.required) {
        if (specular.measured.empty()) return std::nullopt;
        return specular.measured.back();
    }
    if (!series) return std::nullopt;
    Chains chains(question, *series, specular.required, rays);
    BeyondDepth beyond = shareBeyond(events, chains.first(), chains.upTo(events));
    if (specular.measured.empty()) return beyond;
    const BeyondDepth& further = specular.measured.back();
    beyond.share = further.share + (1.0 - further.share) * beyond.share;
    beyond.standardError = std::hypot(beyond.standardError, further.standardError);
    return beyond;
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
    if (!answer.specular.measured.empty() && answer.specular.measured.front().depth > kUsual) {
        const std::uint32_t swallowing = answer.specular.measured.front().depth;
        reason +=
            words::joined(", and ", std::to_string(swallowing), " of them leave ",
                          words::percent(std::pow(facts.mostReflectance, swallowing)), " of what sets out");
    }
    if (const auto& missing = answer.specular.missing) {
        reason += words::joined(": after event ", std::to_string(missing->depth), " comes ",
                                shareWords(*missing, answer.tolerance));
        if (missing->depth == answer.plan.maxSpecular && !isEnough(*missing, answer.tolerance))
            reason += words::joined(", and no more than ", std::to_string(missing->depth),
                                    " are followed: ", lackWords(*missing, answer.tolerance));
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
