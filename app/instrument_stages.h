// In which order do the instruments measure? The dial first, for it is dragged; then what the scene requires,
// and what its parts cost; last the trade, one setting after the other.
#pragma once

#include <atomic>
#include <functional>

#include "app/light_answer.h"

namespace halfdisk {

/// What is kept while only P, N and the like change.
struct InstrumentCache {
    std::shared_ptr<const PreparedScene> scene;
    std::uint64_t seed = 0;
    std::uint32_t depth = 0;
    std::uint32_t specular = 0;         ///< of the trade
    std::optional<std::uint32_t> wall;  ///< whose profile was measured; none: the eye's strip
    double effort = 1.0;
    double tolerance = 0.0;
    std::vector<Forced> forced;
    InstrumentAnswers answers;
    std::optional<TradeReference> reference;
};

/// What is known already of what is asked.
void recallInstruments(LightAnswer& answer, InstrumentCache& cache);

/// What the dial counts, if it is wanted: fast enough to follow a hand.
void answerDial(LightAnswer& answer, InstrumentCache& cache, const std::atomic<bool>& cancelled);

/// What the scene requires, if it is wanted: before all that takes long.
void answerRequirements(LightAnswer& answer, InstrumentCache& cache, const std::atomic<bool>& cancelled);

/// Stage 5: measures what the question wants and calls `publish` after each piece; returns early if
/// cancelled.
void measureInstruments(LightAnswer& answer, InstrumentCache& cache, const std::atomic<bool>& cancelled,
                        const std::function<void()>& publish);

/// What trade and requirements are about: what the scene's eye sees, or else the light along P's wall.
Sensor instrumentSensor(const LightQuestion& asked);

}  // namespace halfdisk
