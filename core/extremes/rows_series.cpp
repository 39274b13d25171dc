// Rows of the series: light that a closed room never swallows, and what a limit on the bounces hides.
#include <stdexcept>

#include "core/estimate.h"
#include "core/exact.h"
#include "core/extremes/furnace.h"
#include "core/extremes/rows.h"
#include "core/radiosity.h"

namespace halfdisk {
namespace {

/// Share of the whole series that lies beyond `depth` bounces: a^(D + 1).
double truncatedShare(double albedo, std::uint32_t depth) {
    return std::pow(albedo, depth + 1.0);
}

std::string truncatedWords(double albedo, std::uint32_t depth) {
    if (albedo == 1.0) return "cut off: without end, each bounce brings as much as the one before";
    return "cut off: " + shortText(100.0 * truncatedShare(albedo, depth)) + " % of all light";
}

ExtremeCell depthCell(double albedo, std::uint32_t depth) {
    FurnaceQuestion question;
    question.albedo = albedo;
    question.depth = depth;
    question.paths = depth > 100 ? 120 : 1200;
    return {"albedo:" + shortText(albedo) + "-depth-" + std::to_string(depth),
            "a closed room of albedo " + shortText(albedo) + ", " + std::to_string(depth) + " bounces",
            "E, relative",
            furnaceBound(depth),
            "(4 D + 16) / 2 roundings for D bounces",
            [question](const StopQuestion& stop) {
                ExtremeOutcome outcome =
                    furnaceOutcome(furnaceOf(furnacePolygon(), question.albedo), {}, question, {}, stop);
                outcome.words = truncatedWords(question.albedo, question.depth);
                return outcome;
            }};
}

/// 1 / (1 - a) summed bounce by bounce until a sum in `Real` no longer grows.
template <class Real>
double naiveEndless(double albedo) {
    Real sum = 0, term = 2;
    for (Real before = -1; sum != before; term *= static_cast<Real>(albedo)) {
        before = sum;
        sum += term;
    }
    return static_cast<double>(sum);
}

// The matrix of a room of albedo a has its eigenvalues between 1 - a and 1 + a: a condition of 2 / (1 - a).
// Cholesky on n unknowns is off by a few sqrt(n) h of the condition (n h at worst); the form factors, exact
// to 1e-13 each, add as much: 2 / (1 - a) * 1e-13.
ExtremeCell endlessCell(double albedo) {
    return {"albedo:" + shortText(albedo) + "-endless",
            "a closed room of albedo " + shortText(albedo) + ", all bounces (radiosity, solved)",
            "E, relative",
            2.0 / (1.0 - albedo) * 1e-13,
            "rounding and form factors (1e-13), times the condition 2 / (1 - albedo)",
            [albedo](const StopQuestion& stop) {
                const Scene furnace = furnaceOf(furnacePolygon(), albedo);
                const SegmentIndex index(furnace);
                const Radiosity light(index, 60, std::nullopt, stop);
                const double exact = 2.0 / (1.0 - albedo);
                ExtremeOutcome outcome;
                Counts counts;
                for (std::uint32_t wall = 0; wall < furnace.segments.size(); ++wall) {
                    const double E = light.irradiance(shadedPointOn(index, wall, 0.37), counts).x;
                    outcome.ours.error = std::max(outcome.ours.error, std::abs(E - exact) / exact);
                }
                outcome.naiveFloat.error = std::abs(naiveEndless<float>(albedo) - exact) / exact;
                outcome.naiveDouble.error = std::abs(naiveEndless<double>(albedo) - exact) / exact;
                outcome.words = "nothing is cut off";
                return outcome;
            }};
}

ExtremeCell refusedCell() {
    return {"albedo:1-endless",
            "a closed room of albedo 1, all bounces: there is no answer",
            "1 if answered",
            0.0,
            "the sum does not converge: only a refusal is right",
            [](const StopQuestion& stop) {
                const Scene furnace = furnaceOf(furnacePolygon(), 1.0);
                const SegmentIndex index(furnace);
                ExtremeOutcome outcome;
                outcome.naiveFloat.error = outcome.naiveDouble.error =
                    1.0;  // it adds, and adds, and never ends
                try {
                    const Radiosity light(index, 60, std::nullopt, stop);
                    outcome.ours.error = 1.0;
                } catch (const std::invalid_argument& refusal) {
                    outcome.words = std::string("refused: ") + refusal.what();
                }
                return outcome;
            }};
}

}  // namespace

void addSeriesRows(std::vector<ExtremeCell>& cells) {
    for (const auto& [albedo, depth] :
         {std::pair{0.0, 5u}, {0.999, 5u}, {0.999, 1000u}, {1.0, 5u}, {1.0, 1000u}})
        cells.push_back(depthCell(albedo, depth));
    cells.push_back(endlessCell(0.999));
    cells.push_back(refusedCell());
}

}  // namespace halfdisk
