#include "lessons/maker.h"

#include <fmt/format.h>

namespace halfdisk {

std::string differenceOf(const Maker& maker, const Maker& other) {
    std::string words;
    const auto add = [&](const std::string& difference) {
        words += (words.empty() ? "" : ", ") + difference;
    };
    const EstimatorInfo& info = *findEstimator(maker.estimator);
    for (std::size_t i = 0; other.estimator == maker.estimator && i < info.params.size(); ++i) {
        const ParamInfo& param = info.params[i];
        const double value = maker.params[i];
        if (value == other.params[i]) continue;
        add(param.choices.empty()
                ? fmt::format("{} {:g}", param.name, value)
                : fmt::format("{} {}", param.name, param.choices[static_cast<std::size_t>(value)]));
    }
    if (maker.depth) add(fmt::format("depth {}", *maker.depth));
    if (maker.specular && maker.specular != other.specular) add(fmt::format("specular {}", *maker.specular));
    return words;
}

std::string titleOf(const Maker& maker, const Maker* other) {
    const std::string title(findEstimator(maker.estimator)->title);
    const std::string difference = other ? differenceOf(maker, *other) : "";
    return difference.empty() ? title : title + ", " + difference;
}

}  // namespace halfdisk
