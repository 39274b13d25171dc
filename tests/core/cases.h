// Which scenes have exact answers, and what are they? The files of tests/cases.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/estimate.h"

namespace halfdisk::test {

/// One exact answer of a case: `wall` and `t`, or a point `at` with a normal.
struct Answer {
    std::string query;  ///< radiance, irradiance or as-printed
    std::string wall;   ///< name of the wall, if the point is given by a wall
    double t = 0.0;
    Vec2 at{0.0}, normal{0.0};
    std::vector<Rgb> depth;                 ///< value at depth 0, 1, ... as far as known
    std::optional<Rgb> unlimited;           ///< with light scattered any number of times
    double err = 0.0;                       ///< absolute bound on each number
    std::map<std::string, double> numbers;  ///< others, by name: variances, what the published code returns

    /// Known beyond the list too if nothing is left to scatter.
    std::optional<Rgb> valueAt(std::size_t atDepth) const;
};

struct Case {
    std::string name;
    Scene scene;
    std::vector<Answer> answers;
};

/// Reads tests/cases/NAME.toml and NAME.answers.toml. Throws for anything that is missing.
Case readCase(const std::string& name);

ShadedPoint pointOf(const SegmentIndex& index, const Answer& answer);

/// The quantity that the answer is about, from an irradiance: E itself, or the wall's outgoing radiance.
Rgb quantityOf(const SegmentIndex& index, const Answer& answer, const Rgb& irradiance);

/// Depth setting that gives the answer's value at `depth`: E at D, but L at D + 1. Empty for L at depth 0,
/// which is Le.
std::optional<std::uint32_t> depthSetting(const Answer& answer, std::size_t depth);

}  // namespace halfdisk::test
