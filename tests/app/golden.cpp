// Where are the golden pictures, and when does a picture match its golden one?
#include "golden.h"

#include "app/commands.h"
#include "app/picture.h"
#include "rig.h"

namespace halfdisk {

std::filesystem::path goldenFolder() {
    return std::filesystem::path(HALFDISK_ROOT) / "assets/golden";
}

std::string goldenName(const LessonRef& step) {
    return step.lesson + "-" + std::to_string(step.step);
}

std::filesystem::path goldenFile(const LessonRef& step, std::size_t scale) {
    return goldenFolder() / (scale == 0 ? "" : "scale2") / (goldenName(step) + ".png");
}

std::vector<LessonRef> courseSteps() {
    std::vector<LessonRef> steps;
    for (const LessonEntry& entry : listLessons(courseLessons())) {
        if (!entry.error.empty()) throw InputError(entry.error);
        for (int step = 1; step <= entry.steps; ++step) steps.push_back({entry.slug, step});
    }
    return steps;
}

std::vector<Image> picturesOfStep(const LessonRef& step) {
    HeadlessHost plain(kGoldenWidth, kGoldenHeight, kGoldenScales[0]),
        large(kGoldenWidth, kGoldenHeight, kGoldenScales[1]);
    HeadlessHost* const hosts[] = {&plain, &large};
    return picturesOf(openLesson(courseLessons(), step), hosts);
}

bool matches(const Image& actual, const Image& golden) {
    if (actual.width != golden.width || actual.height != golden.height) return false;
    return compareImages(actual, golden, kToleranceLevels).outliers <= kMostOutliers;
}

}  // namespace halfdisk
