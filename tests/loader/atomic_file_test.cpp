// Does a file hold the old bytes or the new ones, and nothing else lie beside it?
#include "lessons/atomic_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "lessons/scene_file.h"
#include "temp_folder.h"

using namespace halfdisk;

namespace {

long countFiles(const std::filesystem::path& folder) {
    return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

}  // namespace

TEST_CASE("writing replaces the bytes and leaves nothing beside them") {
    const TempFolder folder;
    const auto path = folder.path / "a b.bin";
    writeFileAtomically(path, "first, and longer");
    const std::string second("new\0bytes", 9);
    writeFileAtomically(path, second);
    CHECK(readAll(path) == second);
    CHECK(countFiles(folder.path) == 1);
}

TEST_CASE("permissions of an existing file are kept and links are followed") {
    const TempFolder folder;
    const auto path = folder.write("real.txt", "old");
    REQUIRE(::chmod(path.c_str(), 0640) == 0);
    std::filesystem::create_symlink("real.txt", folder.path / "link.txt");
    writeFileAtomically(folder.path / "link.txt", "new");
    CHECK(readAll(path) == "new");
    CHECK(std::filesystem::is_symlink(folder.path / "link.txt"));
    CHECK(std::filesystem::status(path).permissions() == std::filesystem::perms(0640));
}

TEST_CASE("a write that fails says so and leaves nothing behind") {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path / "taken");
    CHECK_THROWS_WITH_AS(writeFileAtomically(folder.path / "taken", "x"),
                         doctest::Contains("taken: the file cannot"), std::runtime_error);
    CHECK_THROWS_WITH_AS(writeFileAtomically(folder.path / "none" / "x", "x"),
                         doctest::Contains("cannot be written"), std::runtime_error);
    CHECK_THROWS_AS(writeFileAtomically("", "x"), std::runtime_error);
    CHECK(countFiles(folder.path) == 1);
}

TEST_CASE("a pipe stays what it is, also behind a link") {
    const TempFolder folder;
    const std::filesystem::path pipe = folder.path / "pipe", link = folder.path / "link";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    std::filesystem::create_symlink(pipe, link);
    for (const auto& path : {pipe, link})
        CHECK_THROWS_AS(writeFileAtomically(path, "new"), std::runtime_error);
    CHECK(std::filesystem::is_fifo(pipe));
}

TEST_CASE("a scene that could not be loaded again is not saved over a good one") {
    const TempFolder folder;
    const auto path = folder.path / "scene.toml";
    SceneDescription scene;
    scene.title = "Good";
    scene.shapes.push_back({"floor", SegmentShape{{0, 0}, {1, 0}}, "", Rgb(0.0), false});
    saveScene(scene, path);
    CHECK(loadScene(path) == scene);
    const std::string good = readAll(path);
    scene.shapes[0].geometry = SegmentShape{{0, 0}, {0, 0}};
    CHECK_THROWS_AS(saveScene(scene, path), InputError);
    CHECK(readAll(path) == good);
    CHECK(countFiles(folder.path) == 1);
}
