// Is a file that cannot be a scene refused at once, before it is read?
#include <doctest/doctest.h>
#include <unistd.h>

#include <ctime>

#include "lessons/lesson_file.h"
#include "lessons/scene_file.h"
#include "lessons/text_file.h"
#include "temp_folder.h"

using namespace halfdisk;

namespace {

std::string refusal(const std::filesystem::path& path) {
    try {
        loadScene(path);
    } catch (const InputError& error) {
        CHECK(error.file == path.string());
        CHECK(error.line == 0);
        return error.what();
    }
    return "accepted";
}

/// Seconds of this process's processor time that `work` takes.
template <class Work>
double processorSeconds(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

TEST_CASE("a file of 100 MB is refused without being read") {
    const TempFolder folder;
    const auto path = folder.write("big.toml", "");
    REQUIRE(::truncate(path.c_str(), 100'000'000) == 0);
    std::string message;
    // Reading and checking 100 MB takes a good part of a second; a look at the size takes microseconds.
    CHECK(processorSeconds([&] { message = refusal(path); }) < 0.02);
    CHECK(message == path.string() + ": the file has 100000000 bytes, expected at most 4000000");
    CHECK_THROWS_AS(loadLesson(path), InputError);
}

TEST_CASE("the size limit is exact") {
    const TempFolder folder;
    CHECK(readTextFile(folder.write("full.toml", std::string(kMaxFileBytes, '#'))).size() == kMaxFileBytes);
    CHECK_THROWS_AS(readTextFile(folder.write("over.toml", std::string(kMaxFileBytes + 1, '#'))), InputError);
}

TEST_CASE("a circle of 10^9 segments is refused without being made") {
    const double seconds = processorSeconds([] {
        CHECK_THROWS_AS(parseScene("[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = 1000000000", "x"),
                        InputError);
    });
    CHECK(seconds < 0.02);
}

TEST_CASE("what is no file is refused") {
    const TempFolder folder;
    CHECK(refusal(folder.path / "none.toml").find("there is no such file") != std::string::npos);
    CHECK(refusal(folder.path).find("this is a directory") != std::string::npos);
    CHECK(refusal(folder.path / "none" / "x.toml").find("there is no such file") != std::string::npos);
    CHECK(refusal(folder.write("a.toml", "") / "x.toml").find("a.toml/x.toml: ") != std::string::npos);
    CHECK(refusal("/dev/zero").find("not a regular file") != std::string::npos);
}

TEST_CASE("an empty file is an empty scene") {
    const TempFolder folder;
    CHECK(loadScene(folder.write("empty.toml", "")) == SceneDescription{});
    CHECK(loadScene(folder.write("bom.toml", "\xef\xbb\xbftitle = \"x\"\r\n")).title == "x");
}
