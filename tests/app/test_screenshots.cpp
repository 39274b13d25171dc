// Does every step of every lesson still look as it should? Each is compared with assets/golden/SLUG-STEP.png.
// After an intended change `ninja -C build goldens` makes them anew (make_goldens.cpp).
//
// HALFDISK_STEP=gather:2 picks one step; without it all are compared.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "app/commands.h"
#include "app/picture.h"
#include "golden.h"
#include "rig.h"

using namespace halfdisk;

namespace {

constexpr const char* kHowToMake = "ninja -C build goldens";

std::vector<LessonRef> stepsToCompare() {
    if (const char* one = std::getenv("HALFDISK_STEP")) return {parseLessonRef(one)};
    return courseSteps();
}

/// Empty if it matches; else what is wrong and where to look.
std::string complaint(const Image& actual, const LessonRef& step, std::size_t scale) {
    const auto file = goldenFile(step, scale);
    const std::string name = goldenName(step) + (scale == 0 ? "" : ".scale2");
    if (!std::filesystem::exists(file))
        return fmt::format("{} is missing; make it with: {}", file.string(), kHowToMake);
    const Image golden = readPng(file);
    if (matches(actual, golden)) return {};

    const std::filesystem::path folder = HALFDISK_DIFFERENCES;
    std::filesystem::create_directories(folder);
    const auto actualFile = folder / (name + ".actual.png");
    writePng(actualFile, actual);
    if (actual.width != golden.width || actual.height != golden.height)
        return fmt::format("{} has another size than {}", actualFile.string(), file.string());
    const ImageComparison compared = compareImages(actual, golden, kToleranceLevels);
    const auto differenceFile = folder / (name + ".difference.png");
    writePng(differenceFile, compared.picture);
    return fmt::format(
        "{} pixels differ by more than {} levels (at most {} may), the worst by {}.\n"
        "  golden:     {}\n  actual:     {}\n  difference: {}\nIf the change is intended: {}",
        compared.outliers, kToleranceLevels, kMostOutliers, compared.largestDifference, file.string(),
        actualFile.string(), differenceFile.string(), kHowToMake);
}

Image pictureOfTestStep(const Settings* changed = nullptr) {
    AppState state = openLesson(testLessons(), LessonRef{"controls", 1});
    if (changed) apply(state, SetSettings{*changed});
    HeadlessHost host(kGoldenWidth, kGoldenHeight);
    return pictureOf(std::move(state), host);
}

}  // namespace

TEST_CASE("a step looks like its golden picture") {
    for (const LessonRef& step : stepsToCompare()) {
        const std::vector<Image> pictures = picturesOfStep(step);
        REQUIRE(pictures.size() == kGoldenScales.size());
        for (std::size_t scale = 0; scale < pictures.size(); ++scale) {
            const std::string wrong = complaint(pictures[scale], step, scale);
            CHECK_MESSAGE(wrong.empty(), goldenName(step), " at scale ", kGoldenScales[scale], ": ", wrong);
        }
    }
}

TEST_CASE("every step of the course is registered, and no golden picture is without a step") {
    std::set<std::string> wanted, registered, names;
    for (const LessonRef& step : courseSteps()) {
        wanted.insert(fmt::format("{}:{}", step.lesson, step.step));
        names.insert(goldenName(step));
    }
    if (const char* listed = std::getenv("HALFDISK_REGISTERED_STEPS")) {
        std::istringstream words(listed);
        for (std::string word; words >> word;) registered.insert(word);
        CHECK(registered == wanted);
    }
    CHECK_FALSE(wanted.empty());
    if (!std::filesystem::exists(goldenFolder())) return;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(goldenFolder())) {
        if (entry.path().extension() != ".png") continue;
        CHECK_MESSAGE(names.count(entry.path().stem().string()) == 1, "no step has ", entry.path().string(),
                      "; ", kHowToMake, " removes it");
    }
}

TEST_CASE("the same state gives the same picture, bit for bit") {
    CHECK(pictureOfTestStep() == pictureOfTestStep());
}

TEST_CASE("another seed gives another picture: the comparison can fail") {
    const Image before = pictureOfTestStep();
    Settings settings = openLesson(testLessons(), LessonRef{"controls", 1}).settings;
    CHECK(matches(pictureOfTestStep(&settings), before));
    ++settings.seed;
    CHECK_FALSE(matches(pictureOfTestStep(&settings), before));
}

TEST_CASE("a few stray pixels match, one more does not, and neither does another size") {
    const Image golden = pictureOfTestStep();
    Image actual = golden;
    const auto disturb = [&](std::size_t pixel, int levels) {
        std::uint8_t& red = actual.rgba[4 * 37 * pixel];
        red = static_cast<std::uint8_t>(red > 128 ? red - levels : red + levels);
    };
    for (std::size_t pixel = 0; pixel < 3000; ++pixel) disturb(pixel, kToleranceLevels);
    CHECK(matches(actual, golden));
    actual = golden;
    for (std::size_t pixel = 0; pixel < kMostOutliers; ++pixel) disturb(pixel, 100);
    CHECK(matches(actual, golden));
    disturb(kMostOutliers, kToleranceLevels + 1);
    CHECK_FALSE(matches(actual, golden));
    actual = golden;
    --actual.height;
    actual.rgba.resize(actual.rgba.size() - 4 * static_cast<std::size_t>(actual.width));
    CHECK_FALSE(matches(actual, golden));
}
