#include "core/requirements/bounce_findings.h"

#include <algorithm>
#include <cmath>

#include "core/requirements/series.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

constexpr auto kMostDepth = static_cast<std::uint32_t>(kMaxDepthInfo.most);

// The same random numbers at every depth: a deeper path is the same path, followed further, so that the
// difference is what the further scatterings bring.
std::vector<BeyondDepth> measured(const RequirementsQuestion& question, const Series& series,
                                  double mostAlbedo, std::uint64_t& rays) {
    const Problem problem{
        .index = question.index, .sensor = question.sensor, .seed = question.seed, .stop = question.stop};
    const Pilot all = deepestRun(question, series, rays);
    if (!(all.mean > 0.0)) return {};
    const auto upTo = [&](std::uint32_t depth) {
        Plan plan = series.plan;
        plan.maxDepth = depth;
        Pilot run = pilot(problem, plan, {.rays = 0, .leastPasses = all.passes});
        rays += run.rays;
        return run;
    };
    const std::uint32_t third = series.deepest / 3;
    const Tail tail = tailOf(all, upTo(2 * third), upTo(third), std::pow(mostAlbedo, third));
    std::vector<BeyondDepth> shares;
    for (const std::uint32_t depth : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 8u, 10u, 12u, 16u, 20u, 24u, 32u}) {
        if (depth >= series.deepest) break;
        BeyondDepth beyond = shareBeyond(depth, all, upTo(depth), tail);
        // Few paths that met rare light don't show what it becomes later: no more than walls may keep of it.
        beyond.standardError = std::max(beyond.standardError, lightError(all) * std::pow(mostAlbedo, depth));
        shares.push_back(beyond);
        if (isEnough(shares.back(), question.tolerance)) break;
    }
    return shares;
}

/// By which the last two shares fall with every scattering; nothing where they don't tell.
std::optional<double> fallOf(const std::vector<BeyondDepth>& shares) {
    if (shares.size() < 2) return std::nullopt;
    const BeyondDepth &last = shares.back(), &before = shares[shares.size() - 2];
    if (!(last.share > 0.0) || !(before.share > 0.0)) return std::nullopt;
    return std::min(1.0, std::pow(last.share / before.share, 1.0 / (last.depth - before.depth)));
}

/// Where a measured share, with its error, is enough; else as the last two fell.
std::uint32_t depthOf(const std::vector<BeyondDepth>& shares, double tolerance) {
    if (shares.empty()) return kMaxDepthInfo.initial;
    for (const BeyondDepth& beyond : shares)
        if (isEnough(beyond, tolerance)) return beyond.depth;
    const BeyondDepth& last = shares.back();
    const double most = static_cast<double>(kMaxDepthInfo.most), fall = fallOf(shares).value_or(0.5);
    const double more = std::log(tolerance / mayMiss(last)) / std::log(fall);
    return fall < 1.0 ? static_cast<std::uint32_t>(std::min(most, last.depth + std::ceil(more) + 1.0))
                      : static_cast<std::uint32_t>(most);
}

}  // namespace

std::optional<BeyondDepth> shareBeyondDepth(const BounceFindings& bounces, std::uint32_t depth) {
    if (bounces.patches) {
        const std::vector<BeyondDepth>& beyond = bounces.patches->beyond;
        return beyond[std::min<std::size_t>(depth, beyond.size() - 1)];
    }
    const std::vector<BeyondDepth>& shares = bounces.measured;
    if (shares.empty()) return std::nullopt;
    const auto next =
        std::lower_bound(shares.begin(), shares.end(), depth,
                         [](const BeyondDepth& beyond, std::uint32_t asked) { return beyond.depth < asked; });
    if (next != shares.end() && next->depth == depth) return *next;
    if (next != shares.end() && next != shares.begin()) {
        const BeyondDepth &from = *(next - 1), &to = *next;
        const double part = double(depth - from.depth) / (to.depth - from.depth);
        constexpr double kLeast = 1e-12;
        return BeyondDepth{
            depth,
            std::pow(std::max(kLeast, from.share), 1.0 - part) * std::pow(std::max(kLeast, to.share), part),
            (1.0 - part) * from.standardError + part * to.standardError};
    }
    const BeyondDepth& last = shares.back();
    const std::optional<double> fall = fallOf(shares);
    if (isEnough(last, bounces.tolerance) || !fall) return last;
    const double left = std::pow(*fall, depth - last.depth);
    return BeyondDepth{depth, left * last.share, left * last.standardError};
}

double knownLight(const BounceFindings& bounces, std::uint32_t depth) {
    const auto beyond = shareBeyondDepth(bounces, depth);
    constexpr double kEndless = 0.99;  // of what never ends no part is known
    if (!bounces.patches || mayMiss(*beyond) > kEndless) return 0.0;
    constexpr double kRough = 0.02;
    return (1.0 - kRough) * (1.0 - mayMiss(*beyond)) *
           (bounces.patches->light - kSurely * bounces.patches->lightError);
}

BounceFindings findBounces(const RequirementsQuestion& question, const SceneFacts& facts,
                           const std::optional<Series>& series, std::uint64_t& rays) {
    BounceFindings bounces;
    bounces.byAlbedo = scatteringsUntil(facts.mostAlbedo, question.tolerance);
    if (facts.mostAlbedo == 0.0) return bounces;  // no wall scatters
    if (facts.traits.diffuseOnly) {
        bounces.patches = patchBounces(question.index, question.sensor, question.tolerance, question.stop);
        if (bounces.patches)
            bounces.byRadius = scatteringsUntil(bounces.patches->spectralRadius, question.tolerance);
    }
    bounces.tolerance = question.tolerance;
    if (series) {
        bounces.measured = measured(question, *series, facts.mostAlbedo, rays);
        bounces.dark = bounces.measured.empty() && !bounces.patches;
    }
    if (bounces.patches) {
        // All of them are there, those too that chance rarely finds.
        bounces.missing = bounces.patches->beyond.back();
        bounces.required = bounces.depth = bounces.missing->depth;
        return bounces;
    }
    // So much later is noise, whatever short runs say: the albedo bounds the light of the whole room, and a
    // sensor in its darkest corner sees later light, but not of so many.
    const std::uint32_t most = bounces.byAlbedo ? 4 * std::max(1u, *bounces.byAlbedo) : kMostDepth;
    const std::uint32_t wanted =
        bounces.dark ? most : std::max(1u, depthOf(bounces.measured, question.tolerance));
    bounces.required = bounces.depth = std::min(wanted, most);
    bounces.missing = shareBeyondDepth(bounces, bounces.depth);
    return bounces;
}

std::string bouncesReason(const BounceFindings& bounces, const SceneFacts& facts, double tolerance,
                          double taken) {
    const double left = tolerance - taken;
    if (facts.mostAlbedo == 0.0) return "no wall scatters any light";
    std::string reason;
    if (bounces.dark) reason += "no path that was tried brought any light, so that nothing is known of it; ";
    if (const auto& missing = bounces.missing) {
        reason += words::joined("after bounce ", std::to_string(missing->depth), " comes ",
                                shareWords(*missing, left));
        if (bounces.patches)
            reason += words::joined(", by ", std::to_string(bounces.patches->patches), " patches");
        const bool beyond = !bounces.patches && missing->depth > bounces.measured.back().depth;
        if (beyond)
            reason += words::joined(", if it goes on as it falls up to ",
                                    std::to_string(bounces.measured.back().depth));
        reason += "; ";
        if (missing->depth < bounces.depth && bounces.depth == bounces.required)
            reason += words::joined(std::to_string(bounces.depth), bounces.depth == 1 ? " is" : " are",
                                    " followed all the same: short runs may not have met what is rare; ");
        if (missing->depth == bounces.depth && !isEnough(*missing, left))
            reason += words::joined("no more than ", std::to_string(missing->depth),
                                    " are followed: ", lackWords(*missing, left), "; ");
    }
    constexpr double kTold = 0.01;  // of the tolerance
    reason += words::joined("the tolerance is ", words::percent(tolerance));
    if (taken > kTold * tolerance)
        reason +=
            words::joined(", less ", words::percent(taken), " that mirror and glass events may leave out");
    reason += words::joined(". The largest albedo, ", words::number(facts.mostAlbedo, 3));
    reason += bounces.byAlbedo
                  ? words::joined(", bounds those of the whole room by ", std::to_string(*bounces.byAlbedo))
                  : std::string(", has no bound");
    if (!bounces.patches) return reason;
    reason += words::joined(", the spectral radius, ", words::number(bounces.patches->spectralRadius, 3));
    reason += bounces.byRadius ? words::joined(", by ", std::to_string(*bounces.byRadius))
                               : std::string(", has none");
    return reason;
}

}  // namespace halfdisk
