// Does halfdisk trade measure what it says, can the work be shared, stopped and gone on with, and does it
// come to the same?
#include <doctest/doctest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>

#include "result_files.h"
#include "running_program.h"

using namespace halfdisk_test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> smallTrade(std::vector<std::string> more) {
    std::vector<std::string> arguments{
        "trade",         shippedScene("diffuse_room.toml"), "--width", "8", "--rays", "20000", "--estimators",
        "path,radiosity"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// What time has no part in.
Json timeless(const Json& json) {
    if (json.is_array()) {
        Json rest = Json::array();
        for (const Json& item : json) rest.push_back(timeless(item));
        return rest;
    }
    if (!json.is_object()) return json;
    Json rest = Json::object();
    for (const auto& item : json.items())
        if (item.key().find("econds") == std::string::npos && item.key() != "fingerprint")
            rest[item.key()] = timeless(item.value());
    return rest;
}

Json tradeOf(const fs::path& folder) {
    return readJson(folder / "trade.json");
}

const Json& cellOf(const Json& trade, const std::string& name) {
    for (const Json& cell : trade["cells"])
        if (cell["name"] == name) return cell;
    FAIL("there is no setting " << name);
    return trade;
}

std::size_t cellFiles(const fs::path& folder) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder / "cells"))
        count += entry.is_regular_file() ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("trade: every setting is measured, and table, CSV, JSON and plots tell of it") {
    const TemporaryFolder folder;
    const std::string out = folder / "room";
    const Outcome outcome = runProgram(smallTrade({"-o", out}));
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    const Json trade = tradeOf(out);
    const std::size_t settings = trade["question"]["settings"].size();
    CHECK(settings >= 8);
    CHECK(trade["cells"].size() == settings);
    CHECK(cellFiles(out) == settings);
    for (const Json& cell : trade["cells"]) {
        CHECK(outcome.out.find(cell["name"].get<std::string>()) != std::string::npos);
        CHECK(cell["rays"] >= 20000);
    }
    const std::string csv = readFile(fs::path(out) / "trade.csv");
    CHECK(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) == settings + 1);
    // Every row has as many commas as the head; names have none.
    std::istringstream lines(csv);
    std::string head;
    std::getline(lines, head);
    for (std::string line; std::getline(lines, line);)
        CHECK(std::count(line.begin(), line.end(), ',') == std::count(head.begin(), head.end(), ','));
    for (const char* plot : {"front", "front-seconds", "convergence"}) {
        const std::string svg = readFile(fs::path(out) / (std::string(plot) + ".svg"));
        CHECK(svg.find("<svg") != std::string::npos);
        CHECK(svg.find("</svg>") != std::string::npos);
        CHECK(svg.find("rays") != std::string::npos);
    }
    // All bounces are more light than was asked for: the one bias that is large here.
    CHECK(cellOf(trade, "radiosity solver=solve")["biased"] == true);
    CHECK(outcome.out.find("has all bounces, not 1") != std::string::npos);
    // Paths that end at the first scattering: from which one on chance may end them changes nothing.
    CHECK(cellOf(trade, "path roulette=16")["sameRunAs"] == "path");
    CHECK(cellOf(trade, "path roulette=16")["bySeconds"]["toTarget"] ==
          cellOf(trade, "path")["bySeconds"]["toTarget"]);
    CHECK(outcome.out.find("the same run as path") != std::string::npos);
    CHECK(cellOf(trade, "path emitters=sample")["sameRunAs"] == nullptr);
    CHECK(cellOf(trade, "path")["biased"] == false);
    CHECK(cellOf(trade, "path")["byRays"]["off"] != nullptr);
}

TEST_CASE("trade: parts that are merged are the undivided run, on any number of threads") {
    const TemporaryFolder folder;
    const std::string whole = folder / "whole", merged = folder / "merged";
    REQUIRE(runProgram(smallTrade({"-o", whole, "--threads", "1"})).exitCode == 0);
    std::vector<std::string> merge{"trade", "merge"};
    for (const char* part : {"3/3", "1/3", "2/3"}) {
        const std::string out = folder / (std::string("part") + part[0]);
        const Outcome outcome = runProgram(smallTrade({"--part", part, "-o", out, "--threads", "2"}));
        REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
        CHECK(outcome.out.find("merge joins") != std::string::npos);
        merge.push_back(out);
    }
    merge.insert(merge.end(), {"-o", merged});
    const Outcome outcome = runProgram(merge);
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    CHECK(outcome.err.empty());
    CHECK(timeless(tradeOf(merged)).dump() == timeless(tradeOf(whole)).dump());
    for (const auto& entry : fs::directory_iterator(fs::path(whole) / "cells"))
        CHECK(timeless(readJson(entry.path())) ==
              timeless(readJson(fs::path(merged) / "cells" / entry.path().filename())));
    // Without one part it says what is missing.
    const Outcome partly = runProgram({"trade", "merge", folder / "part1", "-o", folder / "less"});
    CHECK(partly.exitCode == 0);
    CHECK(partly.err.find("settings are in none of these folders") != std::string::npos);
    const std::size_t all = tradeOf(whole)["cells"].size();
    const Json less = tradeOf(folder / "less");
    CHECK(less["missing"].size() == all - less["cells"].size());
    CHECK(partly.out.find("Missing, " + std::to_string(less["missing"].size()) + " of ") !=
          std::string::npos);
    CHECK(tradeOf(whole)["missing"].empty());
    // The reference goes along; one that is damaged is told of, and another taken.
    CHECK(readFile(fs::path(merged) / "reference.json") == readFile(fs::path(whole) / "reference.json"));
    std::ofstream(fs::path(folder / "part3") / "reference.json") << "{\"half\":";
    const Outcome again = runProgram(merge);
    CHECK(again.exitCode == 0);
    CHECK(again.err.find("reference.json: is damaged") != std::string::npos);
    CHECK(readFile(fs::path(merged) / "reference.json") == readFile(fs::path(whole) / "reference.json"));
}

TEST_CASE("trade: what is measured is not measured again") {
    const TemporaryFolder folder;
    const std::string out = folder / "room";
    REQUIRE(runProgram(smallTrade({"-o", out})).exitCode == 0);
    const fs::path cells = fs::path(out) / "cells";
    const std::string kept = readFile(cells / "0000.json"), lost = readFile(cells / "0002.json");
    const Json before = tradeOf(out);
    fs::remove(cells / "0002.json");
    REQUIRE(runProgram(smallTrade({"-o", out})).exitCode == 0);
    CHECK(readFile(cells / "0000.json") == kept);  // its seconds too
    CHECK(timeless(Json::parse(readFile(cells / "0002.json"))) == timeless(Json::parse(lost)));
    CHECK(timeless(tradeOf(out)) == timeless(before));
}

TEST_CASE("trade: Ctrl-C keeps what is measured, and the same command goes on") {
    const TemporaryFolder folder;
    const std::string out = folder / "room";
    const std::vector<std::string> arguments{"trade",        shippedScene("diffuse_room.toml"),
                                             "--width",      "8",
                                             "--budget",     "0.3",
                                             "--estimators", "path,cast-ray",
                                             "-o",           out};
    RunningProgram program(arguments);
    REQUIRE(program.waitUntilBusy(2.0));
    program.signal(SIGINT);
    const Outcome outcome = program.waitForEnd();
    CHECK(outcome.exitCode == 130);
    const std::size_t done = cellFiles(out);
    CHECK(done > 0);
    CHECK(outcome.err.find("halfdisk: stopped: " + std::to_string(done) + " of ") == 0);
    CHECK(outcome.err.find("the same command goes on") != std::string::npos);
    const Json partly = tradeOf(out);
    CHECK(partly["cells"].size() == done);
    CHECK(done < partly["question"]["settings"].size());
    REQUIRE(runProgram(arguments).exitCode == 0);
    CHECK(cellFiles(out) == partly["question"]["settings"].size());
}

TEST_CASE("trade: Ctrl-C in the long run of a reference keeps it, and going on comes to the same") {
    const TemporaryFolder folder;
    const auto asked = [&](const std::string& out) {
        return std::vector<std::string>{"trade",        shippedScene("glass_disk_lamp.toml"),
                                        "--width",      "8",
                                        "--rays",       "400000",
                                        "--estimators", "path",
                                        "--sweep",      "emitters=both",
                                        "-o",           folder / out};
    };
    REQUIRE(runProgram(asked("whole")).exitCode == 0);
    const fs::path out = fs::path(folder / "stopped"), begun = out / "reference.begun.json";
    int stops = 0;
    // Wherever it is stopped: before the run, within it, or hardly before its end.
    for (double busy = 0.2; !fs::exists(out / "reference.json"); busy += 0.2) {
        RunningProgram program(asked("stopped"));
        if (!program.waitUntilBusy(busy)) break;
        program.signal(SIGINT);
        const Outcome outcome = program.waitForEnd();
        if (outcome.exitCode != 130 || !fs::exists(begun)) continue;
        ++stops;
        CHECK(outcome.err.find("passes of the reference are done; the same command goes on") !=
              std::string::npos);
    }
    CHECK(stops > 0);
    REQUIRE(runProgram(asked("stopped")).exitCode == 0);
    CHECK_FALSE(fs::exists(begun));
    CHECK(readFile(out / "reference.json") == readFile(fs::path(folder / "whole") / "reference.json"));
    CHECK(timeless(tradeOf(out)) == timeless(tradeOf(folder / "whole")));
}

TEST_CASE("trade: depth, facets and index are swept, and a depth that is missing shows as bias") {
    const TemporaryFolder folder;
    const std::string out = folder / "disk";
    const Outcome outcome = runProgram({"trade",        shippedScene("glass_disk_lamp.toml"),
                                        "--sensor",     "profile",
                                        "--walls",      "floor,wall",
                                        "--width",      "8",
                                        "--rays",       "20000",
                                        "--estimators", "light",
                                        "--sweep",      "depth=0,1",
                                        "--sweep",      "facets=0.125,1",
                                        "--sweep",      "index=automatic,every wall",
                                        "-o",           out});
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    const Json trade = tradeOf(out);
    CHECK(trade["cells"].size() == 8);
    CHECK(cellOf(trade, "light")["biased"] == false);
    // By which index walls are found changes no bit.
    CHECK(cellOf(trade, "light index=every wall")["variance"] == cellOf(trade, "light")["variance"]);
    CHECK(cellOf(trade, "light facets=0.125")["variance"] != cellOf(trade, "light")["variance"]);
    CHECK(cellOf(trade, "light depth=0")["bias2"][0] > 0.0);
}

TEST_CASE("trade: far from the origin float is biased for sure, double is not, and near it neither is") {
    const TemporaryFolder folder;
    const auto swept = [&](const std::string& scene, const std::string& name) {
        const std::string out = folder / name;
        const Outcome outcome =
            runProgram({"trade", scene, "--width", "16", "--rays", "1000000", "--estimators", "path",
                        "--sweep", "precision=double,float", "-o", out});
        REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
        CHECK(outcome.out.find("path precision=float") != std::string::npos);
        const std::string csv = readFile(fs::path(out) / "trade.csv");
        CHECK(csv.find(",double\n") < csv.find(",float\n"));
        CHECK(csv.find(",float\n") != std::string::npos);
        const Json trade = tradeOf(out);
        CHECK(trade["cells"].size() == 2);
        CHECK(cellOf(trade, "path")["precision"] == "double");
        CHECK(cellOf(trade, "path precision=float")["precision"] == "float");
        CHECK(cellOf(trade, "path")["biased"] == false);
        return trade;
    };
    const Json far = swept(sceneFile("far_room.toml"), "far");
    CHECK(cellOf(far, "path precision=float")["biased"] == true);
    // By their intervals: from its lower end, and to its upper one.
    CHECK(cellOf(far, "path precision=float")["relativeBias"][1] >
          2.0 * cellOf(far, "path")["relativeBias"][2].get<double>());
    const Json near = swept(shippedScene("diffuse_room.toml"), "near");
    CHECK(cellOf(near, "path precision=float")["biased"] == false);
    // Nearly the same rays, but not to the bit.
    CHECK(cellOf(near, "path precision=float")["mean"] != cellOf(near, "path")["mean"]);
    CHECK(cellOf(near, "path precision=float")["mean"].get<double>() ==
          doctest::Approx(cellOf(near, "path")["mean"].get<double>()).epsilon(1e-3));
}

TEST_CASE("trade: a lamp that lies on the ceiling is found in float as in double, by every estimator") {
    const TemporaryFolder folder;
    const std::string out = folder / "room";
    const Outcome outcome =
        runProgram({"trade", shippedScene("diffuse_room.toml"), "--width", "8", "--rays", "20000",
                    "--estimators", "all", "--sweep", "precision=float,double", "-o", out});
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    const Json trade = tradeOf(out);
    int compared = 0;
    for (const Json& cell : trade["cells"]) {
        const std::string name = cell["name"];
        if (name.find("precision") != std::string::npos || cell["refusal"] != "") continue;
        INFO(name);
        // The same random numbers, so nearly the same paths.
        const double mean = cellOf(trade, name + " precision=float")["mean"];
        CHECK(mean == doctest::Approx(cell["mean"].get<double>()).epsilon(0.01));
        ++compared;
    }
    CHECK(compared >= 6);
}

TEST_CASE("trade: a reference of one's own is used, with its error") {
    const TemporaryFolder folder;
    const std::string file = folder / "long.json", out = folder / "room";
    REQUIRE(runProgram({"eye", shippedScene("diffuse_room.toml"), "--width", "8", "--samples", "4000",
                        "--seed", "7", "-o", file})
                .exitCode == 0);
    const Outcome outcome = runProgram(smallTrade({"--reference", file, "-o", out}));
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    const Json trade = tradeOf(out);
    CHECK(trade["reference"]["exact"] == false);
    CHECK(trade["reference"]["relativeError"] > 0.0);
    CHECK(cellOf(trade, "path")["biased"] == false);
    CHECK(cellOf(trade, "radiosity solver=solve")["biased"] == true);
    const Outcome other =
        runProgram({"trade", shippedScene("diffuse_room.toml"), "--width", "9", "--reference", file});
    CHECK(other.exitCode == 2);
    CHECK(other.err.find("= {") != std::string::npos);  // its eye has another width

    // Paths that it gave up are told.
    const std::string blind = folder / "blind.json", mirrors = shippedScene("mirror_room.toml");
    REQUIRE(runProgram({"eye", mirrors, "--width", "8", "--samples", "4", "--specular", "0", "-o", blind})
                .exitCode == 0);
    const Outcome cut = runProgram({"trade", mirrors, "--width", "8", "--specular", "0", "--estimators",
                                    "path", "--rays", "2000", "--reference", blind});
    CHECK(cut.exitCode == 0);
    CHECK_MESSAGE(cut.out.find("paths were given up after 0 mirror and glass events: their light is") !=
                      std::string::npos,
                  cut.out);

    // A picture of something else is no truth.
    const auto refused = [&](const std::vector<std::string>& changed, const std::string& scene,
                             const char* why) {
        const std::string picture = folder / "other.json";
        std::vector<std::string> arguments{
            "eye", shippedScene(scene.c_str()), "--width", "8", "--samples", "2", "-o", picture};
        arguments.insert(arguments.end(), changed.begin(), changed.end());
        REQUIRE(runProgram(arguments).exitCode == 0);
        const Outcome said = runProgram(smallTrade({"--reference", picture}));
        CHECK(said.exitCode == 2);
        CHECK_MESSAGE(said.err.find(why) != std::string::npos, said.err);
    };
    refused({"--depth", "0"}, "diffuse_room.toml", "depth = 0, expected 1");
    refused({"--fov", "20"}, "diffuse_room.toml", "is a picture with eye = ");
    refused({}, "small_lamp_room.toml", "is a picture of another scene");
}

TEST_CASE("trade: a reference by an estimator with a bias is told") {
    const TemporaryFolder folder;
    const std::string file = folder / "rough.json";
    REQUIRE(runProgram({"eye", shippedScene("diffuse_room.toml"), "--width", "8", "--samples", "8",
                        "--estimator", "radiosity", "--param", "patches=8", "-o", file})
                .exitCode == 0);
    const Outcome outcome = runProgram(smallTrade({"--reference", file}));
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    CHECK(outcome.out.find("it is by radiosity, which has a bias that no error tells") != std::string::npos);
}

TEST_CASE("trade: the truth is the deepest that is compared") {
    const TemporaryFolder folder;
    const std::string out = folder / "depths";
    const Outcome outcome = runProgram({"trade", shippedScene("diffuse_room.toml"), "--width", "8", "--rays",
                                        "20000", "--estimators", "path", "--sweep", "depth=0,3", "-o", out});
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    const Json trade = tradeOf(out);
    CHECK(cellOf(trade, "path")["depth"] == 3);
    CHECK(cellOf(trade, "path")["biased"] == false);
    CHECK(cellOf(trade, "path depth=0")["biased"] == true);
    CHECK(outcome.out.find("scattered at most 3 times") != std::string::npos);
}

TEST_CASE("trade: castRay is a hundred times off the front where a small lamp shines through glass") {
    const TemporaryFolder folder;
    const std::string out = folder / "disk";
    REQUIRE(runProgram({"trade", sceneFile("glass_disk_small_lamp.toml"), "--sensor", "profile", "--walls",
                        "floor", "--rays", "300000", "--estimators", "cast-ray,light", "-o", out})
                .exitCode == 0);
    const Json trade = tradeOf(out);
    std::size_t measured = 0;
    for (const Json& cell : trade["cells"]) {
        if (cell["estimator"] != "cast-ray") continue;
        ++measured;
        INFO(cell["name"].get<std::string>());
        const Json& off = cell["byRays"]["offAtTarget"];
        CHECK((off.is_null() || off >= 100.0));
    }
    CHECK(measured >= 8);
    CHECK(cellOf(trade, "light")["byRays"]["offAtTarget"] < 3.0);
}

TEST_CASE("trade: in a matt room radiosity, path and castRay cross") {
    const TemporaryFolder folder;
    const std::string out = folder / "room";
    REQUIRE(runProgram({"trade", shippedScene("diffuse_room.toml"), "--width", "32", "--rays", "100000",
                        "--estimators", "cast-ray,path,radiosity", "-o", out})
                .exitCode == 0);
    const Json trade = tradeOf(out);
    const auto crosses = [&](const char* above, const char* below) {
        for (const Json& crossing : trade["crossingsByRays"])
            if (crossing["above"] == above && crossing["below"] == below) return true;
        return false;
    };
    CHECK(crosses("path", "radiosity"));
    CHECK(crosses("cast-ray", "radiosity"));
}

TEST_CASE("trade: in the dark it ends, and says that there is nothing to compare") {
    const Outcome outcome = runProgram(
        {"trade", sceneFile("no_light.toml"), "--rays", "500", "--width", "4", "--estimators", "path,light"});
    CHECK(outcome.exitCode == 0);
    CHECK(outcome.out.find("no light reaches the sensor") != std::string::npos);
}
