// Does `halfdisk requirements` tell what a scene requires, and does `--estimator auto` do it?
#include <doctest/doctest.h>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "result_files.h"
#include "run_program.h"
#include "running_program.h"

using namespace halfdisk_test;

namespace {

Json asked(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "requirements");
    arguments.emplace_back("--json");
    const Outcome outcome = runProgram(arguments);
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    return Json::parse(outcome.out);
}

/// Processor time of all programs that were run and have ended.
double childrensSeconds() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

Json rowOf(const Json& answer, const std::string& id) {
    for (const Json& row : answer["requirements"])
        if (row["id"] == id) return row;
    FAIL("no requirement ", id);
    return {};
}

void refused(std::vector<std::string> arguments, const std::string& words) {
    const Outcome outcome = runProgram(arguments);
    CHECK(outcome.exitCode == 2);
    CHECK_MESSAGE(outcome.err.find(words) != std::string::npos, outcome.err);
}

}  // namespace

TEST_CASE("requirements: a matt court needs no mirrors, a glass disk in the sun needs paths from the light") {
    const Json court = asked({shippedScene("open_court.toml")});
    CHECK(rowOf(court, "specular")["on"] == false);
    CHECK(rowOf(court, "light-pass")["on"] == false);
    CHECK(court["plan"]["specular"] == 0);
    const Json disk = asked({shippedScene("glass_disk.toml"), "--walls", "floor"});
    CHECK(rowOf(disk, "light-pass")["on"] == true);
    CHECK(rowOf(disk, "light-pass")["reason"].get<std::string>().find("never find it") != std::string::npos);
    CHECK(disk["plan"]["specular"].get<int>() > 0);
}

TEST_CASE("requirements: one closed form where nothing is in the way, and it is told in words") {
    const Outcome outcome = runProgram(
        {"requirements", shippedScene("open_court.toml"), "--at", "floor:0.5", "--tolerance", "0.05"});
    CHECK(outcome.exitCode == 0);
    CHECK(outcome.out.find("estimator closed-form") != std::string::npos);
    CHECK(outcome.out.find("radius, 0.0") != std::string::npos);
}

TEST_CASE("requirements: Ctrl-C keeps what is known of the scene, and the costs that are measured") {
    const auto stoppedAfter = [](double seconds, std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "requirements");
        arguments.emplace_back("--json");
        RunningProgram program(arguments);
        REQUIRE(program.waitUntilBusy(seconds));
        program.signal(SIGINT);
        const Outcome outcome = program.waitForEnd();
        CHECK(outcome.exitCode == 130);
        CHECK_MESSAGE(outcome.err.find("stopped") != std::string::npos, outcome.err);
        return Json::parse(outcome.out);
    };
    const Json early = stoppedAfter(0.2, {shippedScene("glass_disk_lamp.toml"), "--tolerance", "0.0001"});
    CHECK(early["complete"] == false);
    CHECK(early["plan"].is_null());
    CHECK(early["seconds"] > 0.1);
    CHECK(early["paths"].size() > 2);
    // By then the plan is made, also where sanitizers slow it down; the costs would take much longer.
    const double before = childrensSeconds();
    CHECK(asked({shippedScene("diffuse_room.toml")})["complete"] == true);
    const double planned = childrensSeconds() - before;
    const Json late = stoppedAfter(std::max(2.0, 1.5 * planned),
                                   {shippedScene("diffuse_room.toml"), "--costs", "--rays", "3000000"});
    CHECK(late["complete"] == true);
    CHECK(late["costs"]["complete"] == false);
    CHECK(late["costs"]["everything"].is_null());
}

TEST_CASE("requirements: costs have a row for each switch") {
    const Json answer = asked({shippedScene("open_court.toml"), "--costs", "--rays", "5000"});
    std::size_t switchable = 0;
    for (const Json& row : answer["requirements"]) switchable += row["switchable"] == true ? 1 : 0;
    CHECK(answer["costs"]["rows"].size() >= switchable);
    CHECK(answer["costs"]["everything"]["estimator"] == "bidirectional");
}

TEST_CASE("--estimator auto: runs the plan, tells it, and its command gives the same again") {
    const TemporaryFolder folder;
    const std::string first = (folder / "a.json").string(), second = (folder / "b.pfm").string();
    const Outcome outcome =
        runProgram({"eye", shippedScene("diffuse_room.toml"), "--estimator", "auto", "--explain", "--samples",
                    "2", "--width", "8", "-o", first, "-o", second});
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    CHECK(outcome.out.find("bounces") != std::string::npos);
    CHECK(outcome.out.find("plan: ") != std::string::npos);
    const Json result = Json::parse(readFile(first));
    CHECK(result["estimator"] != "auto");
    CHECK(result["command"].get<std::string>().find("auto") == std::string::npos);
    CHECK(result["depth"].get<int>() > 3);
    CHECK(result["specular"] == 0);
}

TEST_CASE("--estimator auto: a depth that is given is kept, and so is what is forced") {
    const std::vector<std::string> probe{"probe",       shippedScene("diffuse_room.toml"),
                                         "--at",        "floor:0.5",
                                         "--estimator", "auto",
                                         "--samples",   "10",
                                         "--json"};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = probe;
        all.insert(all.end(), more.begin(), more.end());
        const Outcome outcome = runProgram(all);
        REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
        return Json::parse(outcome.out);
    };
    CHECK(with({"--depth", "2"})["depth"] == 2);
    CHECK(with({"--force", "bounces=3"})["depth"] == 3);
    CHECK(with({"--force", "light-pass=on"})["requirements"]["plan"]["estimator"] != "path");
    CHECK(with({"--force", "roulette=off"})["parameters"]["roulette"] == 0.0);
}

TEST_CASE("--estimator auto: light that is lost by what is forced is told, without --explain too") {
    const TemporaryFolder folder;
    const std::string picture = (folder / "a.pfm").string(), disk = shippedScene("glass_disk.toml");
    const std::vector<std::vector<std::string>> commands{
        {"probe", disk, "--at", "floor:0.5"},
        {"profile", disk, "--walls", "floor", "--width", "8", "-o", picture},
        {"eye", shippedScene("glass_disk_mirror.toml"), "--width", "8", "-o", picture}};
    const auto run = [](std::vector<std::string> command, const std::vector<std::string>& more) {
        for (const char* one : {"--estimator", "auto", "--samples", "2"}) command.emplace_back(one);
        command.insert(command.end(), more.begin(), more.end());
        const Outcome outcome = runProgram(command);
        REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
        return outcome.out;
    };
    const std::string warning = "\nWARNING: light is missing: the plan carries ";
    for (const auto& command : commands) {
        CAPTURE(command.front());
        CHECK(run(command, {"--force", "light-pass=off"}).find(warning) != std::string::npos);
        CHECK(run(command, {}).find("light is missing") == std::string::npos);
        const Json lossy = Json::parse(run(command, {"--force", "light-pass=off", "--json"}));
        REQUIRE(lossy["loses"].is_string());
        CHECK(lossy["loses"].get<std::string>().find("the plan carries ") == 0);
        CHECK(Json::parse(run(command, {"--json"}))["loses"].is_null());
    }
    const std::vector<std::string> room{"probe", shippedScene("diffuse_room.toml"), "--at", "floor:0.5"};
    CHECK(run(room, {"--depth", "1"}).find("missing: after bounce 1, where paths are cut, comes") !=
          std::string::npos);
    CHECK_FALSE(
        Json::parse(runProgram({"probe", disk, "--at", "floor:0.5", "--json"}).out).contains("loses"));
}

TEST_CASE("requirements: bounces that are forced away are told, and what is forced on has a true reason") {
    const auto run = [](const std::vector<std::string>& more) {
        std::vector<std::string> command{
            "requirements", shippedScene("glass_disk_lamp.toml"), "--sensor", "profile", "--walls", "floor"};
        command.insert(command.end(), more.begin(), more.end());
        const Outcome outcome = runProgram(command);
        REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
        return outcome.out;
    };
    CHECK(run({"--force", "bounces=off"})
              .find("NOTE: light is missing: after bounce 0, where paths are cut, comes ") !=
          std::string::npos);
    CHECK(Json::parse(run({"--force", "bounces=off", "--json"}))["loses"].is_string());
    CHECK(Json::parse(run({"--json"}))["loses"].is_null());
    const Json forced = Json::parse(run({"--force", "photon-pass=on", "--json"}));
    CHECK(rowOf(forced, "photon-pass")["reason"] ==
          "storing photons blurs light that other ways carry as well");
    const Outcome nobody = runProgram({"requirements", shippedScene("diffuse_room.toml"), "--force", "mis=on",
                                       "--force", "light-sampling=off"});
    CHECK(nobody.exitCode == 2);
    CHECK(nobody.err.find("(mis=on, light-sampling=off), expected other ones") != std::string::npos);
}

TEST_CASE("requirements: chains of mirrors that are not followed are told with their share and its error") {
    const std::string tube = sceneFile("mirror_tube.toml"), room = shippedScene("mirror_room.toml");
    const Json longest = asked({tube});
    CHECK(longest["plan"]["specular"] == 1000);
    const std::string lost = longest["loses"];
    CHECK(lost.find("after mirror or glass event 1000, where paths are cut, comes ") == 0);
    const Json& beyond = longest["specular"]["measured"].back();
    CHECK(std::stod(lost.substr(lost.find("comes ") + 6)) ==
          doctest::Approx(100.0 * beyond["beyond"].get<double>()).epsilon(0.06));
    CHECK(lost.find("(\u00b1 ") != std::string::npos);
    CHECK(asked({room})["loses"].is_null());
    CHECK(asked({room, "--force", "specular=off"})["loses"].get<std::string>().find(
              "after mirror or glass event 0, where paths are cut, comes ") == 0);
}

TEST_CASE("requirements: where no short run meets light this is told, and not that nothing is missing") {
    const TemporaryFolder folder;
    const std::string scene = folder / "dark.toml";
    std::ofstream(scene)
        << "[material.silver]\ntype = 'mirror'\n[[box]]\nname = 'room'\nmin = [0, 0]\nmax = [2, 1]\n"
           "facing = 'in'\n[[segment]]\na = [0.3, 0.3]\nb = [0.3, 0.6]\nmaterial = 'silver'\n"
           "[[box]]\nmin = [1, 0.4]\nmax = [1.4, 0.8]\n[[segment]]\nname = 'lamp'\na = [1.3, 0.7]\n"
           "b = [1.1, 0.7]\nemission = 1\n[eye]\nposition = [0.1, 0.1]\ndirection = [1, 1]\n";
    const Json answer = asked({scene});
    CHECK(answer["loses"] == "no short run met any light; if there is some, the plan may lose it");
    CHECK(rowOf(answer, "bounces")["reason"].get<std::string>().find("nothing is known of it") !=
          std::string::npos);
    for (const char* row : {"light-sampling", "roulette"})
        CHECK(rowOf(answer, row)["reason"].get<std::string>().find("met any light") != std::string::npos);
    const Outcome costs = runProgram({"requirements", scene, "--costs", "--rays", "5000"});
    CHECK(costs.out.find("none met") != std::string::npos);
    CHECK(costs.out.find("0.00 \u00b1 0.00 %") == std::string::npos);
    // What is known to be missing is told all the same.
    CHECK(asked({sceneFile("mirror_tube.toml"), "--force", "specular=3"})["loses"].get<std::string>().find(
              "after mirror or glass event 3, ") == 0);
}

TEST_CASE("requirements: reasons are true, whatever is forced away") {
    // Point light, mirrors and an eye: only photons carry all light.
    const std::string disk = shippedScene("glass_disk_mirror.toml");
    const auto reasonOf = [](const Json& answer, const char* id) {
        return rowOf(answer, id)["reason"].get<std::string>();
    };
    for (const char* forced : {"photon-pass=off", "light-pass=off"}) {
        const Json answer = asked({disk, "--force", forced});
        CHECK(answer["loses"].is_string());
        CHECK(reasonOf(answer, "photon-pass") == "only stored photons would carry all light");
        CHECK(reasonOf(answer, "light-pass").find("find all light") == std::string::npos);
    }
    // Of ways that lose light the one that loses least.
    CHECK(asked({disk, "--force", "photon-pass=off"})["plan"]["estimator"] == "bidirectional");
    const Json unasked = asked({sceneFile("room.toml"), "--force", "light-sampling=off"});
    CHECK(reasonOf(unasked, "light-pass") ==
          "lights without size are not asked, and paths from the sensor never meet them");
    CHECK(reasonOf(asked({shippedScene("diffuse_room.toml"), "--force", "roulette=on"}), "roulette") ==
          "following paths to their end was not tried");
    refused({"requirements", sceneFile("room.toml"), "--force", "light-sampling=off", "--force",
             "light-pass=off"},
            "no way of carrying light does what is forced (");
}

TEST_CASE("requirements: a share that chance measured is told with what it was taken for") {
    const Json answer = asked({shippedScene("mirror_room.toml")});
    const Json& beyond = answer["bounces"]["measured"].back();
    REQUIRE(beyond["standardError"] > 0.0);
    const double taken = beyond["beyond"].get<double>() + 2.0 * beyond["standardError"].get<double>();
    CHECK(taken <= answer["tolerance"].get<double>());
    const std::string reason = rowOf(answer, "bounces")["reason"], said = ", with two standard errors added ";
    const std::size_t at = reason.find(said);
    REQUIRE_MESSAGE(at != std::string::npos, reason);
    CHECK(std::stod(reason.substr(at + said.size())) == doctest::Approx(100.0 * taken).epsilon(0.06));
    // Where nothing is left to chance, nothing is added.
    CHECK(rowOf(asked({shippedScene("diffuse_room.toml")}), "bounces")["reason"].get<std::string>().find(
              said) == std::string::npos);
}

TEST_CASE("--explain with any estimator tells what auto would do, and changes nothing") {
    const std::vector<std::string> plain{"probe", shippedScene("open_court.toml"), "--at", "floor:0.5",
                                         "--json"};
    std::vector<std::string> explained = plain;
    explained.emplace_back("--explain");
    Json a = Json::parse(runProgram(plain).out), b = Json::parse(runProgram(explained).out);
    CHECK(a["irradiance"] == b["irradiance"]);
    CHECK(!a.contains("requirements"));
    CHECK(b["requirements"]["plan"].contains("estimator"));
}

TEST_CASE("requirements: what can't be asked is refused in words") {
    const std::string scene = shippedScene("open_court.toml");
    refused({"requirements", scene, "--force", "mis"}, "expected NAME=on");
    refused({"requirements", scene, "--force", "mos=on"}, "names no requirement");
    refused({"requirements", scene, "--force", "mis=3"}, "expected on or off");
    refused({"requirements", scene, "--force", "bounces=-1"}, "expected off or a whole number");
    refused({"requirements", scene, "--force", "colour=off"}, "can't be switched");
    refused({"requirements", scene, "--force", "mis=on", "--force", "mis=off"}, "given twice");
    refused({"requirements", scene, "--tolerance", "0"}, "--tolerance");
    refused({"requirements", scene, "--sensor", "probe"}, "expected --at");
    refused({"requirements", scene, "--sensor", "nose"}, "--sensor");
    refused({"requirements", "/nowhere.toml"}, "nowhere");
    refused({"requirements", scene, "--force", "photon-pass=on", "--force", "light-pass=off"}, "no way");
    refused({"probe", scene, "--at", "floor:0.5", "--force", "mis=on"}, "--estimator auto");
    refused({"probe", scene, "--at", "floor:0.5", "--tolerance", "0.1"}, "--tolerance is for");
    refused({"probe", scene, "--at", "floor:0.5", "--estimator", "auto", "--param", "roulette=0"},
            "expected --force");
    refused(
        {"probe", scene, "--at", "floor:0.5", "--estimator", "auto", "--depth", "1", "--force", "bounces=1"},
        "exclude each other");
}
