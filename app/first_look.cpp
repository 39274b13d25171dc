#include "app/first_look.h"

#include <algorithm>

#include "core/estimators.h"

namespace halfdisk {

std::optional<Maker> firstLookOf(const Maker& maker) {
    const EstimatorInfo& info = *findEstimator(maker.estimator);
    Maker look = maker;
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (const auto& enough = info.params[i].firstLook) look.params[i] = std::min(look.params[i], *enough);
    return look == maker ? std::nullopt : std::optional(look);
}

Sensor coarse(const Sensor& sensor) {
    constexpr std::uint32_t kCoarser = 4;
    Sensor result = sensor;
    if (auto* field = std::get_if<Field>(&result)) {
        field->width = std::max(1u, field->width / kCoarser);
        field->height = std::max(1u, field->height / kCoarser);
    }
    return result;
}

}  // namespace halfdisk
