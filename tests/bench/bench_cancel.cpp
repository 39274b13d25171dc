// How long does work go on that is called off? As long as the window waits when P moves on.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "benches.h"
#include "core/estimators.h"
#include "core/render.h"
#include "core/stop.h"
#include "required.h"
#include "scenes.h"
#include "timing.h"

namespace halfdisk {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

/// ms from the call until the work has ended, which was begun `after` ms before. Both what is prepared
/// (photons, lamps, the exchange between walls) and the passes may be under way. Empty if the estimator
/// refuses.
std::optional<double> callOff(const SegmentIndex& index, const EstimatorInfo& info, double after) {
    Field field;
    field.width = field.height = 64;
    Profile profile;
    for (std::uint32_t i = 0; i < index.scene().segments.size(); ++i) profile.segments.push_back(i);
    profile.bins = 1024;
    std::atomic<bool> off = false;
    const auto isOff = [&] { return off.load(std::memory_order_relaxed); };
    const ParamValues values = initialValues(info);
    Sensor sensor = field;
    Problem problem{.index = index, .sensor = sensor, .maxDepth = 4, .stop = isOff};
    if (!refusalOf(info, problem, values).empty()) {
        sensor = profile;
        if (!refusalOf(info, problem, values).empty()) return std::nullopt;
    }
    std::thread worker([&] {
        RenderOptions options;
        options.passes = 1'000'000'000;
        options.threads = 2;
        options.stop = isOff;
        try {
            render(*info.make(problem, values), sensor, options);
        } catch (const Stopped&) {
            // while it was being prepared
        }
    });
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(after));
    const auto called = Clock::now();
    off = true;
    worker.join();
    return milliseconds(Clock::now() - called);
}

}  // namespace

void benchCancel(Report& report, Effort effort) {
    const bool full = effort == Effort::full;
    report.print(
        "Work that is called off at any time, two threads: ms until it has ended (required: <= {:g})\n",
        kCancelMilliseconds);
    report.print("  {:<16} {:>7} {:>9} {:>9}\n", "estimator", "times", "median", "worst");
    for (const EstimatorInfo* info : estimators()) {
        std::vector<double> waits;
        for (const auto& [name, scene] : lessonScenes()) {
            if (!full && name != "small_room") continue;
            const SegmentIndex index(scene);
            for (int i = 0; i < (full ? 9 : 1); ++i)
                if (const auto wait = callOff(index, *info, 0.5 * std::pow(2.0, i))) waits.push_back(*wait);
        }
        if (waits.empty()) continue;
        const double worst = *std::max_element(waits.begin(), waits.end());
        const auto mark = report.judge(fmt::format("ms until {} has ended", info->id), worst, std::nullopt,
                                       kCancelMilliseconds);
        report.print("  {:<16} {:>7} {:>9.3f} {:>9.3f} {}\n", info->id, waits.size(), quantile(waits, 0.5),
                     worst, mark);
        report.add("cancel", {{"estimator", info->id},
                              {"times", waits.size()},
                              {"median", quantile(waits, 0.5)},
                              {"worst", worst}});
    }
}

}  // namespace halfdisk
