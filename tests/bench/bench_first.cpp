// How soon after a change is there something to see? The first answer about P, and the first picture of each
// kind.
#include <algorithm>
#include <chrono>
#include <thread>

#include "app/commands.h"
#include "app/frame.h"
#include "app/picture_stages.h"
#include "benches.h"
#include "required.h"
#include "timing.h"

namespace halfdisk {
namespace {

struct Waits {
    double point = 0.0, pictures = 0.0;  ///< ms
};

bool showsAllPictures(const AppState& state, const LightAnswer& answer) {
    const auto begun = [](const std::shared_ptr<const LightPicture>& picture) {
        return picture && (picture->film.passes > 0 || !picture->refusal.empty());
    };
    return std::all_of(kPictureViews.begin(), kPictureViews.end(), [&](View view) {
        if (!state.shows(view) || (view == View::eye && !state.scene->scene.eye)) return true;
        return begun(answer.pictures.of(view)) && (!state.makers.second || begun(answer.against.of(view)));
    });
}

/// From the question until each is there, while the light of another seed is still being refined.
Waits waitsAfter(Session& session) {
    AppState& state = session.state;
    Settings settings = state.settings;
    ++settings.seed;
    apply(state, SetSettings{settings});
    const auto start = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    };
    askLight(session);
    Waits waits;
    while (true) {
        const auto answer = session.light.latest();
        if (answer && answer->asked.id == state.questionId) {
            if (waits.point == 0.0) waits.point = passed();
            if (showsAllPictures(state, *answer) || answer->complete) {
                waits.pictures = passed();
                return waits;
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
}

}  // namespace

void benchFirst(Report& report, Effort effort) {
    report.print("Wall time from a change until it is seen, every step as it begins (required: < {} ms)\n",
                 kFirstMilliseconds);
    report.print("  {:<24} {:>12} {:>12} {:>12} {:>12}\n", "lesson", "P, median", "P, most", "all, median",
                 "all, most");
    const auto folder = std::filesystem::path(HALFDISK_ROOT) / "lessons";
    for (const LessonEntry& entry : listLessons(folder)) {
        if (!entry.error.empty()) throw InputError(entry.error);
        if (effort == Effort::quick && entry.slug != "gather") continue;
        std::vector<double> point, pictures;
        for (int step = 1; step <= entry.steps; ++step) {
            Session session;
            session.state = openLesson(folder, LessonRef{entry.slug, step});
            askLight(session);
            session.light.waitUntilIdle(std::chrono::milliseconds(200));
            const Waits waits = waitsAfter(session);
            point.push_back(waits.point);
            pictures.push_back(waits.pictures);
        }
        const double most = quantile(point, 1.0);
        report.print("  {:<24} {:>9.1f} ms {:>9.1f} ms {:>9.1f} ms {:>9.1f} ms  {}\n", entry.slug,
                     quantile(point, 0.5), most, quantile(pictures, 0.5), quantile(pictures, 1.0),
                     report.judge("ms until all are seen, " + entry.slug,
                                  std::max(most, quantile(pictures, 1.0)), std::nullopt, kFirstMilliseconds));
        report.add("first", {{"lesson", entry.slug},
                             {"pointMedian", quantile(point, 0.5)},
                             {"pointMost", most},
                             {"picturesMedian", quantile(pictures, 0.5)},
                             {"picturesMost", quantile(pictures, 1.0)}});
    }
}

}  // namespace halfdisk
