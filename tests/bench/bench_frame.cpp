// How much CPU time does a frame take while P is dragged along the walls?
#include <algorithm>
#include <chrono>
#include <thread>

#include "app/commands.h"
#include "app/frame.h"
#include "app/headless_host.h"
#include "benches.h"
#include "required.h"
#include "timing.h"

namespace halfdisk {
namespace {

/// A place `fraction` of the way round all walls, by number and not by length.
WallPoint along(const Scene& scene, double fraction) {
    const double place = fraction * static_cast<double>(scene.segments.size());
    const auto segment = static_cast<std::uint32_t>(place);
    return {segment, place - segment};
}

/// A millisecond or so of arithmetic that is always the same: what it takes longer at times is the machine's
/// doing.
void fixedWork() {
    volatile double kept = 0.5;
    double x = kept;
    for (int i = 0; i < 250'000; ++i) x = x * (1.0 - x) * 3.9;
    kept = x;
}

/// ms of `work`: CPU time, but no more than has passed. (Where a hypervisor takes a core away, CPU clocks
/// have been seen to count 14 ms in 1.4 ms.)
template <class Work>
double milliseconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    const double cpu = threadSeconds();
    work();
    const double used = threadSeconds() - cpu;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return 1e3 * std::min(used, passed.count());
}

struct Drag {
    std::vector<double> frames;  ///< ms of each
    std::vector<double> fixed;   ///< ms of fixedWork() beside each
};

/// The time of each frame. The answer to each place is shown in later frames, as it comes, while the next is
/// asked for. In full, 60 frames a second as on a screen, so that the light has as long as it has there.
Drag dragAlong(const LessonEntry& entry, Effort effort) {
    const bool full = effort == Effort::full;
    const int frames = full ? 300 : 20;
    const auto host = HeadlessHost::withoutGl(1280, 800);
    Session session;
    session.state = openLesson(entry.path.parent_path(), LessonRef{entry.slug, 1});
    for (const Named<View>& view : kViews) apply(session.state, SetView{view.value, true});
    Settings settings = session.state.settings;
    settings.samples = full ? 64 : 8;
    settings.maxDepth = 2;
    apply(session.state, SetSettings{settings});
    const auto draw = [&] { frame(session, host->fonts(), host->uiScale()); };
    askLight(session);
    session.light.waitUntilIdle();
    constexpr int kWarmUp = 5;
    constexpr std::chrono::microseconds kFrame{16'667};
    auto next = std::chrono::steady_clock::now();
    Drag drag;
    for (int i = -kWarmUp; i < frames; ++i) {
        const double fraction = (i + kWarmUp + 0.5) / (frames + kWarmUp);
        apply(session.state, MovePoint{along(session.state.scene->scene, fraction)});
        const double time = milliseconds([&] { host->frameWithoutDrawing(draw); });
        const double fixed = milliseconds(fixedWork);
        if (i >= 0) {
            drag.frames.push_back(time);
            drag.fixed.push_back(fixed);
        }
        next += kFrame;
        if (full) std::this_thread::sleep_until(next);
    }
    return drag;
}

/// A lesson with a slow frame is dragged through again: what the frame itself costs, it costs again at the
/// same place; what the machine cost, it doesn't.
Drag dragTwiceIfSlow(const Report& report, const LessonEntry& entry, Effort effort) {
    Drag drag = dragAlong(entry, effort);
    const auto slowest = std::max_element(drag.frames.begin(), drag.frames.end());
    if (*slowest <= kFrameMilliseconds) return drag;
    report.print("  {:<24} frame {} took {:.2f} ms, the fixed work beside it {:.2f} ms: once more\n",
                 entry.slug, slowest - drag.frames.begin(), *slowest,
                 drag.fixed[static_cast<std::size_t>(slowest - drag.frames.begin())]);
    const Drag again = dragAlong(entry, effort);
    for (std::size_t i = 0; i < drag.frames.size(); ++i)
        drag.frames[i] = std::min(drag.frames[i], again.frames[i]);
    return drag;
}

}  // namespace

void benchFrame(Report& report, Effort effort) {
    report.print(
        "CPU time per frame while P is dragged, N = 64, maxDepth = 2, every view on (required: < "
        "{} ms)\n",
        kFrameMilliseconds);
    report.print("  {:<24} {:>10} {:>10} {:>10}\n", "lesson", "median", "95 %", "most");
    const auto folder = std::filesystem::path(HALFDISK_ROOT) / "lessons";
    std::vector<double> fixed;
    for (const LessonEntry& entry : listLessons(folder)) {
        if (!entry.error.empty()) throw InputError(entry.error);
        if (effort == Effort::quick && entry.slug != "gather") continue;
        const Drag drag = dragTwiceIfSlow(report, entry, effort);
        fixed.insert(fixed.end(), drag.fixed.begin(), drag.fixed.end());
        const double median = quantile(drag.frames, 0.5), high = quantile(drag.frames, 0.95),
                     most = quantile(drag.frames, 1.0);
        report.print("  {:<24} {:>7.2f} ms {:>7.2f} ms {:>7.2f} ms  {}\n", entry.slug, median, high, most,
                     report.judge("ms per frame, " + entry.slug, most, std::nullopt, kFrameMilliseconds));
        report.add("frame", {{"lesson", entry.slug}, {"median", median}, {"p95", high}, {"most", most}});
    }
    const double usual = quantile(fixed, 0.5), most = quantile(fixed, 1.0);
    report.print("  fixed work beside each frame: median {:.2f} ms, most {:.2f} ms\n", usual, most);
    report.add("fixed work", {{"median", usual}, {"most", most}});
}

}  // namespace halfdisk
