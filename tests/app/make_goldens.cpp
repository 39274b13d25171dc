// How are the golden pictures made? `ninja -C build goldens` draws every step of every lesson, writes those
// that no longer match to assets/golden, and removes those that no step has any more. Look at the changed
// ones before you commit them: they become what is right.
#include <fmt/format.h>

#include <set>

#include "golden.h"

using namespace halfdisk;

namespace {

/// What became of the golden picture of a step.
const char* renew(const Image& picture, const std::filesystem::path& file) {
    const bool isNew = !std::filesystem::exists(file);
    if (!isNew && matches(picture, readPng(file))) return "kept";
    writePng(file, picture);
    return isNew ? "new" : "changed";
}

}  // namespace

int main() {
    try {
        std::filesystem::create_directories(goldenFile({"x", 1}, 1).parent_path());
        std::set<std::filesystem::path> wanted;
        for (const LessonRef& step : courseSteps()) {
            const std::vector<Image> pictures = picturesOfStep(step);
            for (std::size_t scale = 0; scale < pictures.size(); ++scale) {
                const auto file = goldenFile(step, scale);
                wanted.insert(file);
                fmt::print("{:8} {}\n", renew(pictures[scale], file), file.string());
            }
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(goldenFolder())) {
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
