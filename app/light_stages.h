// In which order is the light at P computed? First one recorded run, then the exact answer, then many runs.
// Pictures come after it: picture_stages.h.
#pragma once

#include <atomic>
#include <functional>

#include "app/exact_stages.h"

namespace halfdisk {

/// A window casts no more rays than this for one run of N samples; more is refused with the count.
inline constexpr double kMostRaysPerRun = 2e8;

/// Whether one run is short enough to be finished even when a newer question waits (some 50 ms).
bool isQuick(const LightQuestion& question);

/// Stage 1. When `cancelled` the answer is not to be used.
void recordRun(LightAnswer& answer, const std::atomic<bool>& cancelled);

/// The cloud of the recursion's rays, if there is to be one and it is not made yet. After recordRun.
void makeTreeCloud(LightAnswer& answer, const std::atomic<bool>& cancelled);

/// Whether that is so quick that the first picture can wait for it (some 30 ms).
bool hasQuickCloud(const LightAnswer& answer);

/// The run of another estimator than castRay, if the question wants one. After recordRun.
void recordPathRun(LightAnswer& answer, const std::atomic<bool>& cancelled);

/// Stages 2 and 3; calls `publish` after each that was completed. Sets answer.pointComplete at the end.
void refine(LightAnswer& answer, ReferenceCache& references, const std::atomic<bool>& cancelled,
            const std::function<void()>& publish);

}  // namespace halfdisk
