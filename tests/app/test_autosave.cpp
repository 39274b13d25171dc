// Do unsaved changes outlive a program that is killed?
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "app/autosave.h"
#include "app/edit_commands.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

constexpr long kEnded = 0x3FFFFFFF;  // more than any process has

void moveFirst(AppState& state, double by) {
    SceneDescription scene = state.scene->description;
    moveBy(scene, {ThingKind::shape, 0}, {by, 0.0});
    editScene(state, {scene, std::nullopt, false});
}

}  // namespace

TEST_CASE("a copy is written while there are unsaved changes, and found at the next start") {
    const LessonsCopy folder;
    AppState state = openScene(folder.folder, folder.folder / "scenes/box.toml");
    const auto keep = folder.folder / "state/halfdisk";
    {
        Autosave autosave(keep, kEnded);
        CHECK_FALSE(autosave.recovered().has_value());
        autosave.look(state, 0.0);
        CHECK_FALSE(std::filesystem::exists(autosave.file()));
        moveFirst(state, 0.25);
        autosave.look(state, 0.1);
        CHECK(loadScene(autosave.file()) == state.scene->description);
        moveFirst(state, 0.25);
        autosave.look(state, 0.2);  // not for every little change
        CHECK_FALSE(loadScene(autosave.file()) == state.scene->description);
        autosave.look(state, 0.1 + kAutosaveSeconds);
        CHECK(loadScene(autosave.file()) == state.scene->description);
    }  // as if killed: nobody tidies up
    const Autosave next(keep, kEnded);
    const auto found = next.recovered();
    REQUIRE(found.has_value());
    CHECK(loadScene(*found) == state.scene->description);
    CHECK_FALSE(next.recovered().has_value());
    std::ofstream(next.file()) << "again";
    CHECK(*next.recovered() != *found);
    const Autosave running(keep, static_cast<long>(getpid()));
    std::ofstream(running.file()) << "of a program that still runs";
    CHECK_FALSE(next.recovered().has_value());
}

TEST_CASE("the copy goes when the changes are saved or taken back") {
    const LessonsCopy folder;
    AppState state = openScene(folder.folder, folder.folder / "scenes/box.toml");
    Autosave autosave(folder.folder / "state", kEnded);
    moveFirst(state, 0.25);
    autosave.look(state, 0.0);
    CHECK(std::filesystem::exists(autosave.file()));
    saveEdited(state, {(folder.folder / "mine.toml").string()});
    autosave.look(state, 0.1);
    CHECK_FALSE(std::filesystem::exists(autosave.file()));
    moveFirst(state, 0.25);
    autosave.look(state, 10.0);
    CHECK(std::filesystem::exists(autosave.file()));
    undo(state);
    autosave.look(state, 10.1);
    CHECK_FALSE(std::filesystem::exists(autosave.file()));
}

TEST_CASE("a folder that cannot be written is told once, and the work goes on") {
    const LessonsCopy folder;
    std::ofstream(folder.folder / "state") << "a file where the folder should be";
    AppState state = openScene(folder.folder, folder.folder / "scenes/box.toml");
    Autosave autosave(folder.folder / "state", kEnded);
    moveFirst(state, 0.25);
    autosave.look(state, 0.0);
    CHECK(state.banner.find("cannot be kept") != std::string::npos);
    state.banner.clear();
    moveFirst(state, 0.25);
    autosave.look(state, 100.0);
    CHECK(state.banner.empty());
}

TEST_CASE("a program that was killed counts as dead even before anybody asked how it ended") {
    const LessonsCopy lessons;
    const std::filesystem::path keep = lessons.folder / "state";
    std::filesystem::create_directories(keep);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) _exit(0);
    siginfo_t how{};
    REQUIRE(waitid(P_PID, static_cast<id_t>(child), &how, WEXITED | WNOWAIT) == 0);  // it stays a zombie
    const Autosave killed(keep, child);
    std::ofstream(killed.file()) << "title = \"left\"\n";
    const Autosave next(keep, static_cast<long>(getpid()));
    CHECK(next.recovered().has_value());
    CHECK(waitpid(child, nullptr, 0) == child);
}
