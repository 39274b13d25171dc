// Does the window write what is seen once its light is complete, tell how far it is, and where the files are?
#include <doctest/doctest.h>

#include <fstream>

#include "app/light_progress.h"
#include "export_rig.h"

using namespace halfdisk;

namespace {

namespace fs = std::filesystem;

/// What the bar at the lower edge says; empty: there is none.
std::string message(const Rig& rig) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.window == "Message" && widget.kind == WidgetKind::text) return widget.name.substr(8);
    return {};
}

std::size_t filesIn(const fs::path& folder) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) count += entry.is_regular_file() ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("export: a click writes a new folder each time, once the light is complete") {
    const LessonsCopy folder;
    Rig rig("controls:1");
    rig.driver.click("Controls/Export");
    CHECK(rig.state().exportWished);
    exportIfReady(rig.session, makerOf(rig), folder.folder);
    CHECK_FALSE(rig.state().exportWished);
    rig.driver.frames();
    CHECK(message(rig).find("halfdisk-controls-1") != std::string::npos);
    CHECK(filesIn(folder.folder / "halfdisk-controls-1") >= 4);
    CHECK(fs::exists(folder.folder / "halfdisk-controls-1/canvas.svg"));
    rig.driver.click("Message/Dismiss");
    CHECK(message(rig).empty());
    rig.apply(ExportSeen{});
    exportIfReady(rig.session, makerOf(rig), folder.folder);
    CHECK(fs::exists(folder.folder / "halfdisk-controls-1_2/state.txt"));
    exportIfReady(rig.session, makerOf(rig), folder.folder);  // nothing was wished for
    CHECK_FALSE(fs::exists(folder.folder / "halfdisk-controls-1_3"));
}

TEST_CASE("export: a folder that is used again keeps nothing of an earlier export, and all that is not one") {
    const LessonsCopy folder;
    const fs::path used = folder.folder / "used";
    fs::create_directory(used);
    writeExport(used, {{"eye.csv", "old"}, {"eye.svg", "old"}, {"state.txt", "old"}, {"mine.txt", "mine"}});
    writeExport(used, {{"state.txt", "new"}});
    CHECK_FALSE(fs::exists(used / "eye.csv"));
    CHECK_FALSE(fs::exists(used / "eye.svg"));
    CHECK(fs::exists(used / "mine.txt"));
    CHECK(filesIn(used) == 2);
}

TEST_CASE("export: while the light is not complete nothing is written, and the bar tells how far it is") {
    const LessonsCopy folder;
    Rig rig("controls:1");
    ++rig.session.state.questionId;  // as if something had just been changed
    rig.session.asked = rig.session.state.questionId;
    rig.session.state.exportWished = true;
    CHECK_FALSE(lightIsComplete(rig.state()));
    exportIfReady(rig.session, makerOf(rig), folder.folder);
    CHECK(rig.state().exportWished);
    CHECK_FALSE(fs::exists(folder.folder / "halfdisk-controls-1"));
    rig.driver.frames();
    CHECK(message(rig).find("waits for the light. 0 %: P 0 %") != std::string::npos);
    rig.driver.frames();
    rig.driver.click("Controls/Unlock all");  // the bar takes nothing that is pressed elsewhere
    CHECK(rig.state().unlockAll);
    rig.driver.click("Message/Cancel");
    CHECK_FALSE(rig.state().exportWished);
    rig.session.asked = 0;
    rig.apply(ExportSeen{});
    rig.settle();
    CHECK(lightIsComplete(rig.state()));
    CHECK(lightShare(rig.state()) == 1.0);
    exportIfReady(rig.session, makerOf(rig), folder.folder);
    CHECK(fs::exists(folder.folder / "halfdisk-controls-1/tree.json"));
}

TEST_CASE("export: what cannot be written is told, and leaves nothing behind") {
    const LessonsCopy folder;
    Rig rig("controls:1");
    std::ofstream(folder.folder / "file") << "no folder";
    rig.apply(ExportSeen{});
    exportIfReady(rig.session, makerOf(rig), folder.folder / "file");
    CHECK_FALSE(rig.state().exportWished);
    CHECK(rig.state().banner.find("Nothing is exported: ") == 0);
    rig.session.state.banner.clear();
    rig.apply(ExportSeen{});
    FrameMaker broken = makerOf(rig);
    broken.pixels = []() -> Image { throw std::runtime_error("no pixels"); };
    exportIfReady(rig.session, broken, folder.folder);
    CHECK(rig.state().banner.find("no pixels") != std::string::npos);
    CHECK_FALSE(fs::exists(folder.folder / "halfdisk-controls-1"));
}

TEST_CASE("export: a machine that stands for a class writes nothing") {
    Rig rig("controls:1");
    ClassRules rules;
    rules.kiosk = true;
    setRules(rig.session.state, rules);
    rig.driver.frames(2);
    CHECK(rig.session.widgets.find("Controls/Export") == nullptr);
    rig.driver.pressKey(Key::ctrl, Key::e);
    rig.apply(ExportSeen{});
    CHECK_FALSE(rig.state().exportWished);
}

TEST_CASE("export: a scene without a lesson is named after its file") {
    const LessonsCopy folder;
    const AppState state = openScene(folder.folder, folder.folder / "scenes/box.toml");
    CHECK(newExportFolder(folder.folder, state).filename() == "halfdisk-box");
    fs::create_symlink("nowhere", folder.folder / "halfdisk-box_2");  // taken, too
    CHECK(newExportFolder(folder.folder, state).filename() == "halfdisk-box_3");
    CHECK_THROWS_AS(newExportFolder(folder.folder / "missing", state), std::runtime_error);
}
