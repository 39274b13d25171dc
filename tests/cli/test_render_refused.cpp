// Is a rendering that cannot be made refused before any work, with exit code 2 and one clear line?
#include <doctest/doctest.h>

#include <fstream>

#include "refusals.h"
#include "run_program.h"

using halfdisk_test::checkRefused;
using halfdisk_test::runProgram;
using halfdisk_test::sceneFile;
using halfdisk_test::TemporaryFolder;

namespace {

/// `options` after a view of the room that would work; nothing may be written.
void checkEyeRefused(std::vector<std::string> options, const std::string& message) {
    const TemporaryFolder folder;
    options.insert(options.begin(), {"eye", sceneFile("seen_room.toml"), "-o", folder / "a.png"});
    checkRefused(options, message);
    CHECK(std::filesystem::is_empty(folder.path));
}

void checkOutputRefused(const std::string& output, const std::string& message) {
    checkRefused({"eye", sceneFile("seen_room.toml"), "-o", output}, message);
}

void checkProfileRefused(const std::string& scene, const std::string& walls, const std::string& message) {
    const TemporaryFolder folder;
    checkRefused({"profile", sceneFile(scene), "--walls", walls, "-o", folder / "a.csv"}, message);
    CHECK(std::filesystem::is_empty(folder.path));
}

void checkFieldRefused(const std::string& scene, std::vector<std::string> options,
                       const std::string& message) {
    const TemporaryFolder folder;
    options.insert(options.begin(), {"field", sceneFile(scene), "-o", folder / "a.csv"});
    checkRefused(options, message);
}

}  // namespace

TEST_CASE("the view that the refusals below start from works") {
    const TemporaryFolder folder;
    CHECK(runProgram({"eye", sceneFile("seen_room.toml"), "-o", folder / "a.png"}).exitCode == 0);
    CHECK(std::filesystem::exists(folder / "a.png"));
}

TEST_CASE("refused: estimators and their parameters") {
    checkEyeRefused({"--estimator", "pth"},
                    "halfdisk: --estimator: 'pth' is unknown, expected one of \"cast-ray\", \"path\"");
    checkEyeRefused({"--estimator", "pth"}, "did you mean \"path\"?\n");
    checkEyeRefused(
        {"--param", "roulete=1"},
        "halfdisk: --param: 'roulete=1' names no parameter of path, expected one of \"emitters\"");
    checkEyeRefused({"--param", "roulete=1"}, "did you mean \"roulette\"?\n");
    checkEyeRefused({"--param", "roulette"}, "'roulette' is no parameter, expected NAME=VALUE\n");
    checkEyeRefused({"--param", "=1"}, "'=1' is no parameter, expected NAME=VALUE\n");
    checkEyeRefused({"--param", "roulette=-1"},
                    "'roulette=-1' has a wrong value, expected a whole number from 0 to 1000\n");
    checkEyeRefused({"--param", "roulette=1001"}, "expected a whole number from 0 to 1000\n");
    checkEyeRefused({"--param", "roulette=2.5"}, "expected a whole number from 0 to 1000\n");
    checkEyeRefused({"--param", "roulette="}, "expected a whole number from 0 to 1000\n");
    checkEyeRefused(
        {"--param", "heuristic=powr"},
        "'heuristic=powr' is no choice of heuristic, expected one of \"balance\" or \"power\"; did "
        "you mean \"power\"?\n");
    checkEyeRefused({"--param", "roulette=1", "--param", "roulette=1"}, "'roulette=1' is given twice");
    checkEyeRefused({"--estimator", "cast-ray", "--param", "samples=1e6"}, "more than 10^9 rays");
    checkEyeRefused({"--estimator", "cast-ray", "--param", "samples=0"}, "expected a whole number from 1");
}

TEST_CASE("refused: sensors that an estimator does not serve") {
    checkRefused({"probe", sceneFile("room.toml"), "--at", "0,1", "--look", "1,0", "--estimator", "light"},
                 "halfdisk: light does not serve the sensor look, only: probe, eye, profile, field\n");
}

TEST_CASE("refused: what an estimator cannot do in a scene, and senseless sizes of its work") {
    const std::string glass = halfdisk_test::shippedScene("glass_disk.toml");
    const TemporaryFolder folder;
    const auto check = [&](std::vector<std::string> arguments, const std::string& message) {
        arguments.insert(arguments.end(), {"-o", folder / "a.csv"});
        checkRefused(arguments, message);
        CHECK(std::filesystem::is_empty(folder.path));
    };
    check({"eye", glass, "--estimator", "radiosity"}, "\"disk.0\" is glass");
    check(
        {"profile", sceneFile("room.toml"), "--walls", "room", "--estimator", "closed-form", "--depth", "0"},
        "halfdisk: closed-form ");
    check({"profile", glass, "--walls", "floor", "--estimator", "photon-map", "--param", "photons=0"},
          "'photons=0' has a wrong value, expected a whole number from 1 to 1e+07\n");
    check({"profile", glass, "--walls", "floor", "--estimator", "photon-map", "--param", "photons=1e12"},
          "'photons=1e12' has a wrong value, expected a whole number from 1 to 1e+07\n");
}

TEST_CASE("refused: how long to work") {
    checkEyeRefused({"--samples", "0"},
                    "halfdisk: --samples: '0' is not a whole number from 1 to 1000000000\n");
    checkEyeRefused({"--samples", "1.5"}, "halfdisk: --samples: '1.5' is not a whole number");
    checkEyeRefused({"--seconds", "0"},
                    "halfdisk: --seconds: '0' is not a number of seconds above 0, at most 86400\n");
    checkEyeRefused({"--seconds", "-1"}, "halfdisk: --seconds: '-1' is not a number of seconds");
    checkEyeRefused({"--seconds", "86401"}, "halfdisk: --seconds: '86401' is not a number of seconds");
    checkEyeRefused({"--seconds", "nan"}, "halfdisk: --seconds: 'nan' is not a number of seconds");
    checkEyeRefused({"--samples", "1", "--seconds", "1"},
                    "halfdisk: --samples and --seconds exclude each other, expected one of them\n");
    checkEyeRefused({"--samples", "1e9", "--width", "1000"},
                    "these are 1e+12 samples of pixels, more than 10^11: lower --samples or --width, give "
                    "--seconds, or add --anyway\n");
    checkEyeRefused({"--depth", "1001"}, "halfdisk: --depth: '1001' is not a whole number from 0 to 1000\n");
    checkEyeRefused({"--specular", "1001"}, "halfdisk: --specular: '1001' is not a whole number from 0 to");
    checkEyeRefused({"--threads", "0"}, "halfdisk: --threads: '0' is not a whole number from 1 to 256\n");
    checkEyeRefused({"--seed", "-1"}, "halfdisk: --seed: '-1' is not a whole number");
    checkEyeRefused({"--exposure", "65"}, "halfdisk: --exposure: '65' is not a number from -64 to 64\n");
}

TEST_CASE("refused: files that could not be written") {
    const TemporaryFolder folder;
    checkRefused({"eye", sceneFile("seen_room.toml")}, "--output is required; see halfdisk eye --help\n");
    checkOutputRefused(folder / "a.jpg",
                       "a.jpg' has no known extension, expected one of .png, .pfm, .csv, .json\n");
    checkOutputRefused(folder / "png", "has no known extension");
    checkOutputRefused("", "halfdisk: --output: '' has no known extension");
    checkOutputRefused("/nowhere/a.png",
                       "halfdisk: --output: '/nowhere/a.png' cannot be written: no file can be made in "
                       "/nowhere: No such file or directory\n");
    checkOutputRefused("/proc/a.png", "halfdisk: --output: '/proc/a.png' cannot be written");
    std::filesystem::create_directory(folder / "folder.png");
    checkOutputRefused(folder / "folder.png", "folder.png' is a folder, expected a file's name\n");
    checkEyeRefused({"-o", "/nowhere/b.csv"}, "'/nowhere/b.csv' cannot be written");
    const std::string twice = folder / "a.csv";
    checkEyeRefused({"-o", twice, "-o", twice}, "a.csv' is given twice\n");
}

TEST_CASE("refused: eyes") {
    const TemporaryFolder folder;
    const std::string scene = sceneFile("room.toml");
    checkRefused({"eye", scene, "-o", folder / "a.png"},
                 scene +
                     ": the scene has no eye, expected a table [eye] in it, or --position X,Y and "
                     "--direction X,Y\n");
    checkRefused({"eye", scene, "-o", folder / "a.png", "--position", "0,1"}, "the scene has no eye");
    checkEyeRefused({"--position", "here"}, "halfdisk: --position: 'here' is not a point, expected X,Y\n");
    checkEyeRefused({"--direction", "0,0"}, "halfdisk: --direction: '0,0' has no direction");
    for (const char* fov : {"0", "180", "-90", "wide"})
        checkEyeRefused({"--fov", fov},
                        "is no field of view, expected a number of degrees above 0, at most 179\n");
    checkEyeRefused({"--width", "0"}, "halfdisk: --width: '0' is not a whole number from 1 to 65536\n");
    checkEyeRefused({"--height", "x"}, "halfdisk: --height: 'x' is not a whole number from 1");
    checkEyeRefused(
        {"--width", "65536", "--height", "62"},
        "halfdisk: --width, --height: 65536 x 62 pixels are too many, expected at most 4000000 in "
        "all\n");
}

TEST_CASE("refused: walls of a profile") {
    checkProfileRefused(
        "segment_light.toml", "flor",
        "halfdisk: --walls: 'flor' names no wall, expected one of \"floor\" or \"light\"; did "
        "you mean \"floor\"?\n");
    checkProfileRefused("room.toml", "rom", "expected one of \"room\", \"block\", \"ball\"");
    checkProfileRefused("room.toml", "room.4", "'room.4' names no wall");
    checkProfileRefused("room.toml", "room,", "'' names no wall");
    checkProfileRefused("room.toml", "room,room.2", "names the wall \"room.2\" twice");
    checkProfileRefused("open_sky.toml", "all",
                        "open_sky.toml: the scene has no wall, expected one at least\n");
    checkRefused({"profile", sceneFile("room.toml"), "-o", "a.csv"}, "--walls is required");
}

TEST_CASE("refused: corners and cells of a field") {
    const std::string noExtent = "the scene has no extent, expected --min X,Y and --max X,Y\n";
    checkFieldRefused("open_sky.toml", {}, noExtent);
    checkFieldRefused("open_sky.toml", {"--min", "0,0"}, noExtent);
    checkFieldRefused("room.toml", {"--min", "0,0", "--max", "0,1"},
                      "halfdisk: --min, --max: from (0, 0) to (0, 1) is no area, expected");
    checkFieldRefused("room.toml", {"--min", "0,5"}, "is no area");
    checkFieldRefused("room.toml", {"--min", "x"}, "halfdisk: --min: 'x' is not a point");
    checkFieldRefused("room.toml", {"--width", "2001", "--height", "2000"},
                      "2001 x 2000 pixels are too many, expected at most 4000000 in all\n");
}
