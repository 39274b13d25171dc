// How are the golden pictures made? `ninja -C build goldens` draws every step of every lesson, writes those
// that changed to assets/golden, and removes those that no step has any more. Look at the changed ones before
// you commit them: they become what is right.
#include <fmt/format.h>

#include <set>

#include "golden.h"

using namespace halfdisk;

namespace {

/// What became of the golden picture of a step.
const char* renew(const LessonRef& step) {
    const Image picture = pictureOfStep(step);
    const auto file = goldenFile(step);
    const bool isNew = !std::filesystem::exists(file);
    if (!isNew && readPng(file) == picture) return "kept";
    writePng(file, picture);
    return isNew ? "new" : "changed";
}

}  // namespace

int main() {
    try {
        std::filesystem::create_directories(goldenFolder());
        std::set<std::filesystem::path> wanted;
        for (const LessonRef& step : courseSteps()) {
            wanted.insert(goldenFile(step));
            fmt::print("{:8} {}\n", renew(step), goldenFile(step).string());
        }
        for (const auto& entry : std::filesystem::directory_iterator(goldenFolder())) {
            if (entry.path().extension() != ".png" || wanted.count(entry.path()) > 0) continue;
            fmt::print("removed  {}\n", entry.path().string());
            std::filesystem::remove(entry.path());
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_goldens: {}\n", error.what());
        return 1;
    }
    return 0;
}
