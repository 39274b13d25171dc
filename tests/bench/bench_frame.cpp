// How much CPU time does a frame take while P is dragged along the walls?
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

/// ms of each frame. The answer to each place is shown in later frames, as it comes, while the next is asked
/// for. In full, 60 frames a second as on a screen, so that the light has as long as it has there.
std::vector<double> dragAlong(const LessonEntry& entry, Effort effort) {
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
    std::vector<double> milliseconds;
    for (int i = -kWarmUp; i < frames; ++i) {
        const double fraction = (i + kWarmUp + 0.5) / (frames + kWarmUp);
        apply(session.state, MovePoint{along(session.state.scene->scene, fraction)});
        const double start = threadSeconds();
        host->frameWithoutDrawing(draw);
        if (i >= 0) milliseconds.push_back(1e3 * (threadSeconds() - start));
        next += kFrame;
        if (full) std::this_thread::sleep_until(next);
    }
    return milliseconds;
}

}  // namespace

void benchFrame(Report& report, Effort effort) {
    report.print(
        "CPU time per frame while P is dragged, N = 64, maxDepth = 2, every view on (required: < {} ms)\n",
        kFrameMilliseconds);
    report.print("  {:<24} {:>10} {:>10} {:>10}\n", "lesson", "median", "95 %", "most");
    const auto folder = std::filesystem::path(HALFDISK_ROOT) / "lessons";
    for (const LessonEntry& entry : listLessons(folder)) {
        if (!entry.error.empty()) throw InputError(entry.error);
        if (effort == Effort::quick && entry.slug != "gather") continue;
        const std::vector<double> times = dragAlong(entry, effort);
        const double median = quantile(times, 0.5), high = quantile(times, 0.95), most = quantile(times, 1.0);
        report.print("  {:<24} {:>7.2f} ms {:>7.2f} ms {:>7.2f} ms  {}\n", entry.slug, median, high, most,
                     report.judge("ms per frame, " + entry.slug, most, std::nullopt, kFrameMilliseconds));
        report.add("frame", {{"lesson", entry.slug}, {"median", median}, {"p95", high}, {"most", most}});
    }
}

}  // namespace halfdisk
