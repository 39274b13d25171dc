#include "lessons/instruments.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {

InstrumentSettings withinLimits(InstrumentSettings settings) {
    const InstrumentSettings initial;
    const auto limit = [](double& value, double least, double most, double otherwise) {
        value = std::isnan(value) ? otherwise : std::clamp(value, least, most);
    };
    limit(settings.dial.scale, kLeastScale, kMostScale, initial.dial.scale);
    limit(settings.dial.offset, 0.0, kMostOffset, initial.dial.offset);
    limit(settings.dial.gap, 0.0, kMostGap, initial.dial.gap);
    limit(settings.dial.fixedEpsilon, kLeastEpsilon, kMostEpsilon, initial.dial.fixedEpsilon);
    limit(settings.wishedError, kLeastWishedError, kMostWishedError, initial.wishedError);
    limit(settings.wishedMilliseconds, kLeastMilliseconds, kMostMilliseconds, initial.wishedMilliseconds);
    limit(settings.tolerance, kLeastTolerance, kMostTolerance, initial.tolerance);
    std::vector<Forced> forced;
    for (const Forced& one : settings.forced) {
        const bool known = std::any_of(forced.begin(), forced.end(),
                                       [&](const Forced& other) { return other.id == one.id; });
        if (!known && infoOf(one.id).kind != Switch::none) forced.push_back(one);
    }
    settings.forced = std::move(forced);
    return settings;
}

}  // namespace halfdisk
