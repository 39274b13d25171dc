// Can a result be repeated: from its own file, and with any number of threads?
#include <doctest/doctest.h>

#include <cstdlib>

#include "core/estimators.h"
#include "result_files.h"
#include "run_program.h"

using namespace halfdisk_test;

namespace {

/// The arguments that a shell makes of a text, by the shell itself.
std::vector<std::string> shellWords(const std::string& text) {
    const TemporaryFolder folder;
    const std::string list = folder / "words";
    const std::string script = "printf '%s\\n' " + text + " > " + list;
    REQUIRE(std::system(script.c_str()) == 0);
    std::vector<std::string> words;
    std::string word;
    for (const char c : readFile(list)) {
        if (c != '\n') {
            word += c;
            continue;
        }
        words.push_back(word);
        word.clear();
    }
    return words;
}

void run(std::vector<std::string> arguments, const std::string& output) {
    arguments.insert(arguments.end(), {"-o", output});
    const Outcome outcome = runProgram(arguments);
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
}

/// The command that a JSON file names gives that file again, and a CSV the same.
void checkRepeats(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const std::string first = folder / "first.json", again = folder / "again.json", csv = folder / "a.csv";
    run(arguments, first);
    const std::string command = readJson(first)["command"];
    CAPTURE(command);
    run(shellWords(command), again);
    CHECK(withoutSeconds(again) == withoutSeconds(first));
    run(shellWords(command), csv);
    CHECK(readCsv(csv).facts["command"] == readJson(first)["command"].dump());
}

/// A scene file under another name.
std::string copyScene(const TemporaryFolder& folder, const std::string& name) {
    const std::string copy = folder / name;
    std::filesystem::copy_file(sceneFile("seen_room.toml"), copy);
    return copy;
}

}  // namespace

TEST_CASE("the command in a file gives the same file again") {
    checkRepeats({"eye", sceneFile("seen_room.toml"), "--width", "30"});
    checkRepeats({"eye", sceneFile("seen_room.toml"), "--position", "0.1,0.7", "--direction", "-3,0.7",
                  "--fov", "33.3", "--exposure", "-0.7", "--width", "17", "--height", "2"});
    checkRepeats({"profile", sceneFile("room.toml"), "--walls", "room,ball", "--estimator", "light",
                  "--param", "spread=stratified", "--depth", "3", "--seed", "18446744073709551615",
                  "--samples", "11"});
    checkRepeats({"field", sceneFile("room.toml"), "--max", "1.9,1.1", "--width", "13", "--estimator",
                  "cast-ray", "--param", "samples=3", "--samples", "5", "--specular", "7"});
}

TEST_CASE("every estimator's file names a command that gives it again") {
    for (const halfdisk::EstimatorInfo* info : halfdisk::estimators()) {
        CAPTURE(info->id);
        const std::string depth = info->id == "closed-form" ? "0" : "1";
        if (info->sensors & halfdisk::kProfileBit)
            checkRepeats({"profile", sceneFile("segment_light.toml"), "--walls", "floor", "--estimator",
                          std::string(info->id), "--depth", depth, "--samples", "3", "--width", "5"});
    }
}

TEST_CASE("a result of --seconds is repeated by the number of its samples") {
    checkRepeats({"eye", sceneFile("seen_room.toml"), "--width", "30", "--seconds", "0.02"});
}

TEST_CASE("names of files that a shell would take apart are quoted") {
    const TemporaryFolder folder;
    checkRepeats({"eye", copyScene(folder, "my room's $HOME; eye.toml"), "--width", "4"});
}

TEST_CASE("the same bytes for any number of threads, others for another seed") {
    for (const halfdisk::EstimatorInfo* info : halfdisk::estimators()) {
        if (!(info->sensors & halfdisk::kProfileBit)) continue;
        CAPTURE(info->id);
        const std::string depth = info->id == "closed-form" ? "0" : "1";  // it is direct light alone
        const TemporaryFolder folder;
        const auto render = [&](const std::string& threads, const std::string& seed) {
            const std::string file = folder / (threads + "-" + seed + ".json");
            // 600 bins: 6 samples make a chunk, so there are several, and the last is smaller.
            run({"profile", sceneFile("segment_light.toml"), "--walls", "floor", "--width", "600",
                 "--samples", "20", "--estimator", std::string(info->id), "--depth", depth, "--threads",
                 threads, "--seed", seed},
                file);
            return file;
        };
        const std::string one = render("1", "5");
        CHECK(withoutSeconds(render("2", "5")) == withoutSeconds(one));
        CHECK(withoutSeconds(render("3", "5")) == withoutSeconds(one));
        CHECK(readJson(render("1", "6"))["mean"] != readJson(one)["mean"]);
    }
}
