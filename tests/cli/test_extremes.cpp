// Does `halfdisk extremes` print its table, refuse what it can't do, and take a scene of one's own?
#include <doctest/doctest.h>

#include <algorithm>
#include <csignal>
#include <sstream>

#include "app/extremes_report.h"
#include "result_files.h"
#include "run_program.h"
#include "running_program.h"

using namespace halfdisk_test;

TEST_CASE("extremes: every row is a test of its own") {
    const std::string tested = HALFDISK_EXTREME_ROWS;
    std::string rows = halfdisk::rowNames(halfdisk::extremeCells());
    rows.erase(std::remove(rows.begin(), rows.end(), ' '), rows.end());
    CHECK(tested == rows);
}

TEST_CASE("extremes: a row, a cell, as a table and as JSON") {
    const Outcome table = runProgram({"extremes", "--only", "gap,critical:+1e-6"});
    CHECK_MESSAGE(table.exitCode == 0, table.err);
    for (const char* part : {"gap:1e-3", "gap:1e-7", "critical:+1e-6", "4 of 4 hold"})
        CHECK_MESSAGE(table.out.find(part) != std::string::npos, part);
    CHECK(table.out.find("scale:") == std::string::npos);
    std::istringstream lines(table.out);
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 120);

    const Json object = Json::parse(runProgram({"extremes", "--only", "gap:1e-5", "--json"}).out);
    REQUIRE(object["cells"].size() == 1);
    CHECK(object["complete"] == true);
    CHECK(object["scene"].is_null());
    const Json& cell = object["cells"][0];
    CHECK(cell["id"] == "gap:1e-5");
    CHECK(cell["holds"] == true);
    CHECK(cell["ours"]["leaks"] == 0);
    CHECK(cell["naiveDouble"]["leaks"].get<int>() > 1000);
    CHECK(cell["naiveDoubleHolds"] == false);
    CHECK_FALSE(cell["why"].get<std::string>().empty());
}

TEST_CASE("extremes: the list tells each bound's reason, and measures nothing") {
    const Outcome list = runProgram({"extremes", "--list"});
    CHECK(list.exitCode == 0);
    for (const halfdisk::ExtremeCell& cell : halfdisk::extremeCells())
        CHECK_MESSAGE(list.out.find(cell.id + " ") != std::string::npos, cell.id);
}

TEST_CASE("extremes: a scene of one's own") {
    const Json object =
        Json::parse(runProgram({"extremes", shippedScene("diffuse_room.toml"), "--json"}).out);
    CHECK(object["cells"].size() >= 7);
    for (const Json& cell : object["cells"]) CHECK_MESSAGE(cell["holds"] == true, cell.dump());
    const Outcome empty = runProgram({"extremes", sceneFile("open_sky.toml")});
    CHECK(empty.exitCode == 2);
    CHECK(empty.err.find("no wall") != std::string::npos);
}

TEST_CASE("extremes: what there is not is refused") {
    const Outcome unknown = runProgram({"extremes", "--only", "gaps"});
    CHECK(unknown.exitCode == 2);
    CHECK(unknown.err.find("gaps") != std::string::npos);
    CHECK(unknown.err.find("gap, ") != std::string::npos);
    CHECK(runProgram({"extremes", "/nowhere.toml"}).exitCode == 2);
}

TEST_CASE("scene check tells whether float would hold the scene") {
    const Outcome table = runProgram({"scene", "check", sceneFile("room.toml")});
    CHECK(table.out.find("decided in double") != std::string::npos);
    const Json object = Json::parse(runProgram({"scene", "check", sceneFile("room.toml"), "--json"}).out);
    CHECK(object["float"]["bentWalls"] == 0);
}

TEST_CASE("extremes: Ctrl-C keeps the lines that are done") {
    RunningProgram program({"extremes", "--only", "radiance,samples,scale", "--json"});
    // The rows of scale come first and take less than this, that of 1e9 samples much more.
    REQUIRE(program.waitUntilBusy(1.5));
    program.signal(SIGINT);
    const Outcome outcome = program.waitForEnd();
    CHECK(outcome.exitCode == 130);
    const Json object = Json::parse(outcome.out);
    CHECK(object["complete"] == false);
    CHECK(object["cells"].size() >= 1);
    CHECK(object["cells"].size() < 11);
    CHECK(object["cells"][0]["id"] == "scale:1e-6");
}
