#include "lessons/maker.h"

#include <fmt/format.h>

namespace halfdisk {

std::string titleOf(const Maker& maker, const Maker* other) {
    const EstimatorInfo& info = *findEstimator(maker.estimator);
    std::string title(info.title);
    if (other == nullptr) return title;
    if (other->estimator == maker.estimator)
        for (std::size_t i = 0; i < info.params.size(); ++i) {
            const ParamInfo& param = info.params[i];
            const double value = maker.params[i];
            if (value == other->params[i]) continue;
            title += param.choices.empty()
                         ? fmt::format(", {} {:g}", param.name, value)
                         : fmt::format(", {} {}", param.name, param.choices[static_cast<std::size_t>(value)]);
        }
    if (maker.depth) title += fmt::format(", depth {}", *maker.depth);
    return title;
}

}  // namespace halfdisk
