// How does the grid of strategies grow behind the frame? Batch by batch of passes, as the pictures do.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "app/light_answer.h"
#include "core/estimators/strategy_passes.h"

namespace halfdisk {

/// A grid on its way. It is kept while only P (but for the profile's wall), N, and the maker's own s and t
/// change.
class StrategyWork {
 public:
    /// `cancelled` outlives it, and calls off whatever is under way.
    StrategyWork(const LightQuestion& asked, const std::atomic<bool>& cancelled);
    StrategyWork(const StrategyWork&) = delete;  // the passes refer to the sensor
    StrategyWork& operator=(const StrategyWork&) = delete;

    bool answers(const LightQuestion& question) const;
    /// False, and nothing is added, if cancelled on the way.
    bool addBatch();
    const std::shared_ptr<const StrategyGrid>& grid() const { return grid_; }

 private:
    std::shared_ptr<const PreparedScene> scene_;
    Sensor sensor_;
    Maker maker_;
    std::uint64_t seed_;
    double effort_;
    std::optional<StrategyPasses> passes_;
    std::shared_ptr<const StrategyGrid> grid_;
};

/// The grid as far as it is done already, if it is wanted.
void recallStrategies(LightAnswer& answer, const std::unique_ptr<StrategyWork>& work);

/// Makes `work` what the question wants: false if there is nothing (more) to do.
bool prepareStrategies(const LightQuestion& asked, std::unique_ptr<StrategyWork>& work,
                       const std::atomic<bool>& cancelled);

}  // namespace halfdisk
