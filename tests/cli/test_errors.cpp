// Does every mistake on the command line end with exit code 2 and one clear line?
#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "refusals.h"
#include "run_program.h"

using halfdisk_test::checkRefused;
using halfdisk_test::Outcome;
using halfdisk_test::runProgram;
using halfdisk_test::runProgramInto;
using halfdisk_test::sceneFile;
using halfdisk_test::TemporaryFolder;

namespace {

/// `options` after a probe of the floor that would work.
void checkProbeRefused(std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"probe", sceneFile("segment_light.toml"), "--at", "floor:0.5"});
    checkRefused(options, message);
}

void checkPlaceRefused(const std::string& at, const std::string& message) {
    checkRefused({"probe", sceneFile("segment_light.toml"), "--at", at}, message);
}

}  // namespace

TEST_CASE("refused: places") {
    checkPlaceRefused("foo", "halfdisk: --at: 'foo' is not a point, expected X,Y or NAME:T\n");
    checkPlaceRefused("", "halfdisk: --at: '' is not a point, expected X,Y or NAME:T\n");
    checkPlaceRefused("nan,0", "halfdisk: --at: 'nan,0' is not a point");
    checkPlaceRefused("0,inf", "halfdisk: --at: '0,inf' is not a point");
    checkPlaceRefused("1e10,0", "halfdisk: --at: '1e10,0' is too far away");
    checkPlaceRefused("1,2,3", "halfdisk: --at: '1,2,3' is not a point");
    checkPlaceRefused("floor:2", "halfdisk: --at: \"floor:2\" has no place on its wall");
    checkPlaceRefused("floor:nan", "halfdisk: --at: \"floor:nan\" has no place on its wall");
    checkPlaceRefused(
        "flor:0.5",
        "halfdisk: --at: there is no wall \"flor\", expected one of \"floor\" or \"light\"; did you "
        "mean \"floor\"?\n");
    checkPlaceRefused("0,1.5",
                      "is on no wall (the nearest, \"light\", is 0.5 m away), expected a point on a wall, or "
                      "--normal X,Y too\n");
    checkRefused({"probe", sceneFile("open_sky.toml"), "--at", "0,0"},
                 "is on no wall (the scene has no walls)");
    checkRefused({"probe", sceneFile("open_sky.toml"), "--at", "floor:0.5"}, "there is no wall \"floor\"");
}

TEST_CASE("refused: values of the probe") {
    checkProbeRefused({"--normal", "0,0"}, "halfdisk: --normal: '0,0' has no direction");
    checkProbeRefused({"--normal", "inf,0"},
                      "halfdisk: --normal: 'inf,0' is not a direction, expected X,Y\n");
    checkProbeRefused({"--samples", "-5"},
                      "halfdisk: --samples: '-5' is not a whole number from 1 to 1000000000\n");
    checkProbeRefused({"--samples", "0"}, "halfdisk: --samples: '0' is not a whole number from 1");
    checkProbeRefused({"--samples", "99999999999999999999"},
                      "halfdisk: --samples: '99999999999999999999' is not");
    checkProbeRefused({"--samples", "many"}, "halfdisk: --samples: 'many' is not a whole number");
    checkProbeRefused({"--samples="}, "halfdisk: --samples= lacks a value");
    checkProbeRefused({"--samples"}, "halfdisk: --samples: 1 required N missing");
    checkProbeRefused({"--samples", "1", "--samples", "2"}, "halfdisk: --samples");
    checkProbeRefused({"--depth", "1001"},
                      "halfdisk: --depth: '1001' is not a whole number from 0 to 1000\n");
    checkProbeRefused({"--seed", "18446744073709551616"}, "halfdisk: --seed: '18446744073709551616' is not");
    checkProbeRefused({"--repeat", "0"}, "halfdisk: --repeat: '0' is not a whole number from 1");
    checkProbeRefused({"--threads", "0"}, "halfdisk: --threads: '0' is not a whole number from 1 to 256\n");
    checkProbeRefused({"--threads", "257"},
                      "halfdisk: --threads: '257' is not a whole number from 1 to 256\n");
    checkProbeRefused({"--estimator", "photon"},
                      "halfdisk: --estimator: 'photon' is unknown, expected one of \"cast-ray\", \"path\"");
    checkProbeRefused({"--sampler", "cosin"}, "did you mean \"cosine\"?\n");
    checkProbeRefused({"--emitters", "never"}, "expected one of \"sample\", \"hit\" or \"both\"\n");
    checkProbeRefused({"--as-printed=frame,bogus"},
                      "halfdisk: --as-printed: 'bogus' is unknown, expected one of \"frame\"");
    checkProbeRefused({"--as-printed="}, "halfdisk: --as-printed= lacks a value");
    checkProbeRefused({"--as-printed", "frame"}, "not expected: frame; see halfdisk probe --help\n");
}

TEST_CASE("refused: what the parser itself finds") {
    checkProbeRefused({"--bogus"}, "not expected: --bogus; see halfdisk probe --help\n");
    checkProbeRefused({"more"}, "not expected: more; see halfdisk probe --help\n");
    checkRefused({"--bogus"}, "not expected: --bogus; see halfdisk --help\n");
    checkRefused({"probe"}, "SCENE is required; see halfdisk probe --help\n");
    checkRefused({"probe", sceneFile("room.toml")}, "--at is required; see halfdisk probe --help\n");
    checkRefused({"scene"}, "subcommand is required; see halfdisk scene --help\n");
    checkRefused({"scene", "check"}, "FILE is required; see halfdisk scene check --help\n");
    checkRefused({"lessons", "extra"}, "not expected: extra; see halfdisk lessons --help\n");
    checkRefused({"gather", "lessons"}, "'gather' was not expected");
    checkRefused({"--scene", "a.toml", "lessons"}, "--scene was not expected");
}

TEST_CASE("refused: lessons and pictures") {
    checkRefused({"gather:0"}, "halfdisk: \"gather:0\" names no step");
    checkRefused({"gather:x"}, "halfdisk: \"gather:x\" names no step");
    checkRefused({":"}, "halfdisk: \":\" names no lesson");
    checkRefused({"screenshot", "gather"}, "--output is required; see halfdisk screenshot --help\n");
    checkRefused({"screenshot", "gather", "-o", "a.png", "--size", "319x800"},
                 "halfdisk: --size: '319x800' is not a size");
    checkRefused({"screenshot", "gather", "-o", "a.png", "--scale", "4.5"},
                 "halfdisk: --scale: '4.5' is not a number from 0.5 to 4\n");
    checkRefused({"screenshot", "gather", "-o", "a.png", "--scale", "nan"},
                 "halfdisk: --scale: 'nan' is not a number");
    checkRefused({"tour"}, "--output is required; see halfdisk tour --help\n");
}

TEST_CASE("refused: files, with the file's name first") {
    const std::string unknownKey = sceneFile("unknown_key.toml");
    checkRefused({"scene", "check", unknownKey}, unknownKey + ":7:1: ");
    checkRefused({"probe", unknownKey, "--at", "0,0"}, unknownKey + ":7:1: ");
    checkRefused({"scene", "write", unknownKey, "-o", "/dev/null"}, unknownKey + ":7:1: ");
    checkRefused({"scene", "check", "/nowhere/room.toml"}, "/nowhere/room.toml: ");
    checkRefused({"lessons", "--lessons", "/nowhere"}, "/nowhere: ");
}

TEST_CASE("a path that cannot be written is bad input, whichever command is told it") {
    const TemporaryFolder folder;
    const std::string aFile = folder / "file";
    std::ofstream(aFile) << "no folder";
    const std::string scene = std::string(HALFDISK_SHIPPED_SCENES) + "/small_room.toml";
    for (const std::string& bad : {std::string("/proc/nope/x.png"), aFile + "/x.png"})
        for (const std::vector<std::string>& command : {std::vector<std::string>{"screenshot", "gather"},
                                                        {"export", "gather"},
                                                        {"tour"},
                                                        {"scene", "write", scene},
                                                        {"eye", scene, "--samples", "1"}}) {
            std::vector<std::string> arguments = command;
            arguments.insert(arguments.end(), {"-o", bad});
            checkRefused(arguments, "halfdisk: --output: '");
        }
}

TEST_CASE("an output that cannot be written is a failure, not a crash") {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--help"},
          {"--version"},
          {"scene", "check", sceneFile("room.toml")},
          {"probe", sceneFile("room.toml"), "--at", "lamp:0.5", "--json"}}) {
        const Outcome full = runProgramInto("/dev/full", arguments);
        CHECK(full.exitCode == 1);
        CHECK(full.err.find("halfdisk: the output cannot be written") == 0);
        const Outcome closed = runProgramInto("", arguments);
        CHECK(closed.exitCode == 1);
        CHECK(closed.err.find("halfdisk: the output cannot be written") == 0);
    }
    const Outcome write = runProgram({"scene", "write", sceneFile("room.toml"), "-o", "/nowhere/room.toml"});
    CHECK(write.exitCode == 2);  // a path that was given wrong
    CHECK(write.err.find("halfdisk: ") == 0);
}
