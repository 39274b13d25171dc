// Do help, version, the list of lessons and the scene commands tell what they should?
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli.h"
#include "core/settings.h"
#include "lessons/scene_file.h"
#include "run_program.h"

using namespace halfdisk_test;
using Json = nlohmann::ordered_json;

namespace {

bool holds(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

void writeText(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
    REQUIRE(readFile(path) == text);
}

/// A lesson of two steps, with its scene.
void writeLesson(const TemporaryFolder& folder) {
    writeText(folder / "floor.scene", "[[segment]]\nname = \"floor\"\na = [0.0, 0.0]\nb = [2.0, 0.0]\n");
    writeText(
        folder / "04-floor.toml",
        "title = \"A floor\"\nsection = \"Floors\"\nscene = \"floor.scene\"\n"
        "[[step]]\ntitle = \"One\"\nprose = \"First.\"\n[[step]]\ntitle = \"Two\"\nprose = \"Second.\"\n");
}

}  // namespace

TEST_CASE("every command has its help, with examples") {
    for (const std::vector<std::string>& command : {std::vector<std::string>{},
                                                    {"lessons"},
                                                    {"screenshot"},
                                                    {"export"},
                                                    {"tour"},
                                                    {"probe"},
                                                    {"eye"},
                                                    {"profile"},
                                                    {"field"},
                                                    {"estimators"},
                                                    {"extremes"},
                                                    {"scene"},
                                                    {"scene", "check"},
                                                    {"scene", "write"}}) {
        std::vector<std::string> arguments = command;
        arguments.push_back("--help");
        const Outcome outcome = runProgram(arguments);
        CHECK(outcome.exitCode == 0);
        CHECK(outcome.err == "");
        CHECK(holds(outcome.out, "Example"));
        for (const std::string& word : command) CHECK(holds(outcome.out, word));
    }
    CHECK(holds(runProgram({"--help"}).out, "Exit codes: 0 success, 1 failure, 2 bad input"));
    CHECK_FALSE(holds(runProgram({"--help"}).out, "has-display"));
}

TEST_CASE("the help of probe lists every name with its meaning") {
    const std::string help = runProgram({"probe", "--help"}).out;
    const auto check = [&](const auto& table) {
        for (const auto& entry : table) {
            CHECK(holds(help, entry.name));
            CHECK(holds(help, entry.meaning));
        }
    };
    check(halfdisk::kSamplers);
    check(halfdisk::kEmitters);
    check(halfdisk::kDefects);
}

TEST_CASE("the version is the project's") {
    CHECK(halfdisk::kVersion == HALFDISK_PROJECT_VERSION);
    CHECK(runProgram({"--version"}).out == "halfdisk " HALFDISK_PROJECT_VERSION "\n");
}

TEST_CASE("without a display, has-display says so by its exit code alone") {
    const Outcome outcome = runProgram({"has-display"});
    CHECK(outcome.exitCode == 1);
    CHECK(outcome.out == "");
}

TEST_CASE("scene check counts what is in the file") {
    const Outcome outcome = runProgram({"scene", "check", sceneFile("room.toml"), "--json"});
    REQUIRE(outcome.exitCode == 0);
    const Json counts = Json::parse(outcome.out);
    CHECK(counts["title"] == "Room");
    CHECK(counts["segments"] == 4 + 4 + 12 + 3 + 2 + 1);
    CHECK(counts["segmentsByShape"].dump() ==
          R"({"segment":1,"polyline":2,"polygon":4,"box":4,"circle":12,"arc":3,"lens":0})");
    CHECK(counts["materials"] == 2);  // red, and the default
    CHECK(counts["lights"].dump() == R"({"point":1,"directional":1})");
    CHECK(counts["emitters"] == 1);
    CHECK(counts["bounds"].dump() == R"({"min":[-2.0,0.0],"max":[2.0,2.0]})");
    const std::string table = runProgram({"scene", "check", sceneFile("room.toml")}).out;
    CHECK(holds(table, "12 segments of 1 circle"));
    CHECK(holds(table, "x -2 to 2 m, y 0 to 2 m"));
    CHECK(holds(table, "2 diffuse"));
    CHECK(counts["materialsByType"]["diffuse"] == 2);
    CHECK(counts["hiddenLamps"].empty());
    CHECK(Json::parse(runProgram({"scene", "check", sceneFile("open_sky.toml"), "--json"}).out)["bounds"]
              .is_null());
}

TEST_CASE("scene check warns of a lamp that its ceiling hides") {
    const TemporaryFolder folder;
    const std::string ceiling = "[[segment]]\nname = \"ceiling\"\na = [2, 2]\nb = [0, 2]\n";
    const std::string lamp = "[[segment]]\nname = \"lamp\"\na = [1.4, 2]\nb = [0.6, 2]\nemission = 1\n";
    const auto warned = [&](const std::string& text) {
        std::ofstream(folder / "scene.toml") << text;
        return holds(runProgram({"scene", "check", folder / "scene.toml"}).out,
                     "\"lamp\" lies on \"ceiling\", which is written before it and hides it");
    };
    CHECK(warned(ceiling + lamp));
    CHECK_FALSE(warned(lamp + ceiling));
    const std::string frame = "[[segment]]\nname = \"frame\"\na = [1.2, 2]\nb = [1, 2]\n";
    std::ofstream(folder / "scene.toml") << frame + lamp;
    CHECK(holds(runProgram({"scene", "check", folder / "scene.toml"}).out,
                "\"lamp\" lies on \"frame\", which is written before it and hides a part of it"));
}

TEST_CASE("scene write saves an equal scene, and writing that again the same bytes") {
    const TemporaryFolder folder;
    const std::string once = folder / "once.toml", twice = folder / "twice.toml";
    CHECK(runProgram({"scene", "write", sceneFile("room.toml"), "-o", once}).exitCode == 0);
    CHECK(halfdisk::loadScene(once) == halfdisk::loadScene(sceneFile("room.toml")));
    CHECK(runProgram({"scene", "write", once, "-o", twice}).exitCode == 0);
    CHECK(readFile(once) == readFile(twice));
    CHECK(runProgram({"scene", "write", once, "-o", once}).exitCode == 0);
    CHECK(readFile(once) == readFile(twice));
}

TEST_CASE("lessons are listed, and --lessons stands before or after the command") {
    const TemporaryFolder folder;
    writeLesson(folder);
    const std::string course = folder.path;
    const Outcome json = runProgram({"lessons", "--lessons", course, "--json"});
    CHECK(json.exitCode == 0);
    CHECK(json.out ==
          R"({"lessons":[{"number":4,"slug":"floor","title":"A floor","section":"Floors","steps":2}]})"
          "\n");
    const Outcome table = runProgram({"--lessons", course, "lessons"});
    CHECK(table.exitCode == 0);
    for (const char* part : {"04", "floor", "A floor", "2 steps", "Floors"}) CHECK(holds(table.out, part));
}

TEST_CASE("a broken lesson is listed with its error and hides no other") {
    const TemporaryFolder folder;
    writeLesson(folder);
    const std::string course = folder.path;
    writeText(folder / "05-broken.toml", "title = 5\n");
    const Outcome outcome = runProgram({"lessons", "--lessons", course, "--json"});
    CHECK(outcome.exitCode == 2);
    const Json lessons = Json::parse(outcome.out)["lessons"];
    REQUIRE(lessons.size() == 2);
    CHECK(lessons[0]["slug"] == "floor");
    CHECK(lessons[1]["slug"] == "broken");
    CHECK(holds(lessons[1]["error"], "05-broken.toml:1:"));
    const Outcome table = runProgram({"lessons", "--lessons", course});
    CHECK(table.exitCode == 2);
    CHECK(holds(table.out, "05-broken.toml:1:"));
}
