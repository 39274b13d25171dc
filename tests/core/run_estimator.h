// What does an estimator of the registry say, asked as a test asks? By its row, its parameters by name.
#pragma once

#include <stdexcept>
#include <utility>

#include "core/estimators.h"
#include "core/render.h"

namespace halfdisk::test {

/// All parameters at their initial values but these. Throws for a name that the estimator does not know.
inline ParamValues paramsOf(const EstimatorInfo& info,
                            const std::vector<std::pair<std::string_view, double>>& given) {
    ParamValues values = initialValues(info);
    for (const auto& [name, value] : given) {
        bool known = false;
        for (std::size_t i = 0; i < info.params.size(); ++i)
            if (info.params[i].name == name) {
                values[i] = value;
                known = true;
            }
        if (!known) throw std::invalid_argument("no parameter " + std::string(name));
    }
    return values;
}

struct Ask {
    std::vector<std::pair<std::string_view, double>> params{};
    std::uint32_t maxDepth = 1;
    std::uint64_t passes = 1;
    std::uint64_t seed = 1;
    unsigned threads = 2;
};

/// Throws for what the estimator refuses.
inline Film runEstimator(const EstimatorInfo& info, const SegmentIndex& index, const Sensor& sensor,
                         const Ask& ask) {
    const Problem problem{.index = index, .sensor = sensor, .maxDepth = ask.maxDepth, .seed = ask.seed};
    const ParamValues params = paramsOf(info, ask.params);
    if (const std::string why = refusalOf(info, problem, params); !why.empty())
        throw std::invalid_argument(why);
    const auto estimator = info.make(problem, params);
    RenderOptions options;
    options.passes = ask.passes;
    options.threads = ask.threads;
    return render(*estimator, sensor, options);
}

}  // namespace halfdisk::test
