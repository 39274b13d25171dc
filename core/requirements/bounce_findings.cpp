#include "core/requirements/bounce_findings.h"

#include <algorithm>
#include <cmath>

#include "core/requirements/series.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

// The same random numbers at every depth: a deeper path is the same path, followed further, so that the
// difference is what the further scatterings bring.
std::vector<BeyondDepth> measured(const RequirementsQuestion& question, const Series& series,
                                  double mostAlbedo, std::uint64_t& rays) {
    const Problem problem{
        .index = question.index, .sensor = question.sensor, .seed = question.seed, .stop = question.stop};
    const Pilot all =
        pilot(problem, series.plan,
              {.rays = static_cast<std::uint64_t>(question.effort * kSeriesRays), .leastPasses = 16});
    rays += all.rays;
    const auto upTo = [&](std::uint32_t depth) {
        Plan plan = series.plan;
        plan.maxDepth = depth;
        Pilot run = pilot(problem, plan, {.rays = 0, .leastPasses = all.passes, .mostPasses = all.passes});
        rays += run.rays;
        return run;
    };
    const std::uint32_t third = series.deepest / 3;
    const Tail tail = tailOf(all, upTo(2 * third), upTo(third), std::pow(mostAlbedo, third));
    std::vector<BeyondDepth> shares;
    for (const std::uint32_t depth : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 8u, 10u, 12u, 16u, 20u, 24u, 32u}) {
        if (depth >= series.deepest) break;
        shares.push_back(shareBeyond(depth, all, upTo(depth), tail));
        if (isEnough(shares.back(), question.tolerance)) break;
    }
    return shares;
}

/// By the last measured share, with its error, going on as the last two fell. Sets `ahead` where no depth is
/// enough.
std::uint32_t depthOf(const std::vector<BeyondDepth>& shares, double tolerance,
                      std::optional<BeyondDepth>& ahead) {
    if (shares.empty()) return kMaxDepthInfo.initial;
    for (const BeyondDepth& beyond : shares)
        if (isEnough(beyond, tolerance)) return beyond.depth;
    const BeyondDepth& last = shares.back();
    if (shares.size() < 2) return last.depth + 1;
    const BeyondDepth& before = shares[shares.size() - 2];
    const double fall = std::min(1.0, std::pow(std::max(1e-12, last.share) / std::max(1e-12, before.share),
                                               1.0 / (last.depth - before.depth)));
    const double most = static_cast<double>(kMaxDepthInfo.most),
                 more = std::log(tolerance / std::max(tolerance, mayMiss(last))) / std::log(fall),
                 depth = last.depth + std::ceil(more) + 1.0;
    if (fall < 1.0 && depth <= most) return static_cast<std::uint32_t>(depth);
    const double left = std::pow(fall, most - last.depth);
    ahead = {static_cast<std::uint32_t>(kMaxDepthInfo.most), left * last.share, left * last.standardError};
    return ahead->depth;
}

}  // namespace

BounceFindings findBounces(const RequirementsQuestion& question, const SceneFacts& facts,
                           std::uint32_t maxSpecular, std::uint64_t& rays) {
    BounceFindings bounces;
    bounces.byAlbedo = scatteringsUntil(facts.mostAlbedo, question.tolerance);
    if (facts.mostAlbedo == 0.0) return bounces;  // no wall scatters
    if (facts.traits.diffuseOnly) {
        bounces.patches = patchBounces(question.index, question.sensor, question.tolerance, question.stop);
        if (bounces.patches)
            bounces.byRadius = scatteringsUntil(bounces.patches->spectralRadius, question.tolerance);
    }
    if (const auto series = seriesOf(question, maxSpecular))
        bounces.measured = measured(question, *series, facts.mostAlbedo, rays);
    if (bounces.patches) {
        // All of them are there, those too that chance rarely finds.
        bounces.depth = static_cast<std::uint32_t>(bounces.patches->beyond.size() - 1);
        bounces.required = bounces.depth;
        bounces.missing = {bounces.depth, bounces.patches->beyond.back(), 0.0};
        return bounces;
    }
    bounces.depth = std::max(1u, depthOf(bounces.measured, question.tolerance, bounces.ahead));
    // The albedo bounds the light of the whole room; a sensor in its darkest corner may see later light. So
    // much later is noise.
    if (bounces.byAlbedo) bounces.depth = std::min(bounces.depth, 4 * std::max(1u, *bounces.byAlbedo));
    for (const BeyondDepth& beyond : bounces.measured)
        if (beyond.depth <= bounces.depth) bounces.missing = beyond;
    bounces.required = bounces.depth;
    return bounces;
}

std::string bouncesReason(const BounceFindings& bounces, const SceneFacts& facts, double tolerance,
                          double taken) {
    const double left = tolerance - taken;
    if (facts.mostAlbedo == 0.0) return "no wall scatters any light";
    std::string reason;
    if (const auto& missing = bounces.missing) {
        reason = words::joined("more than ", std::to_string(missing->depth), " scatterings bring ",
                               shareWords(*missing, left));
        if (bounces.patches)
            reason += words::joined(", by ", std::to_string(bounces.patches->patches), " patches");
        reason += "; ";
        if (missing->depth == kMaxDepthInfo.most && !isEnough(*missing, left))
            reason += words::joined("no more than ", std::to_string(missing->depth),
                                    " are followed: ", lackWords(*missing, left), "; ");
        if (missing->depth < bounces.depth && !isEnough(*missing, left))
            reason +=
                words::joined("going on as they fall, ", std::to_string(bounces.depth), " are enough; ");
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
