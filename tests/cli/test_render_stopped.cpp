// Does Ctrl-C keep what is done, and does the bar of progress stay off pipes?
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "app/estimator_arguments.h"
#include "app/interruption.h"
#include "app/measurement.h"
#include "app/progress_bar.h"
#include "lessons/scene_file.h"
#include "result_files.h"
#include "running_program.h"

using namespace halfdisk_test;

namespace {

constexpr double kBusySeconds = 0.1;

/// A run that would take ten minutes is told to stop; its file must hold what was done until then.
void checkStops(int signal) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.json";
    RunningProgram program(
        {"eye", sceneFile("seen_room.toml"), "--width", "16", "--seconds", "600", "-o", file});
    REQUIRE(program.waitUntilBusy(kBusySeconds));
    program.signal(signal);
    const Outcome outcome = program.waitForEnd();
    CHECK(outcome.exitCode == 130);
    const Json result = readJson(file);
    const std::uint64_t samples = result["samples"];
    CHECK(samples > 0);
    CHECK(result["mean"].size() == 16);
    const std::string told = "halfdisk: stopped after " + std::to_string(samples) + " samples in ";
    CHECK_MESSAGE(outcome.err.rfind(told, 0) == 0, outcome.err);
    CHECK(outcome.err.find(" of 600 s; written\n") != std::string::npos);
    CHECK(outcome.out.find("written: ") != std::string::npos);
    // What is in the file is no half of a picture: as many samples give it again.
    const std::string again = folder / "again.json";
    REQUIRE(runProgram({"eye", sceneFile("seen_room.toml"), "--width", "16", "--samples",
                        std::to_string(samples), "-o", again})
                .exitCode == 0);
    CHECK(withoutSeconds(again) == withoutSeconds(file));
}

}  // namespace

TEST_CASE("Ctrl-C and SIGTERM write what is done, say how far it got, and end with 130") {
    checkStops(SIGINT);
    checkStops(SIGTERM);
}

TEST_CASE("stopped within a number of samples, both numbers are told") {
    const TemporaryFolder folder;
    const std::string file = folder / "a.csv";
    RunningProgram program(
        {"eye", sceneFile("seen_room.toml"), "--width", "16", "--samples", "1e9", "-o", file});
    REQUIRE(program.waitUntilBusy(kBusySeconds));
    program.signal(SIGINT);
    const Outcome outcome = program.waitForEnd();
    CHECK(outcome.exitCode == 130);
    CHECK(outcome.err ==
          "halfdisk: stopped after " + readCsv(file).facts["samples"] + " of 1000000000 samples; written\n");
}

TEST_CASE("within the first sample, or in its preparation: nothing is written, and that is said") {
    const TemporaryFolder folder;
    const auto checkStops = [&](std::vector<std::string> arguments) {
        const std::string file = folder / "a.png";
        arguments.insert(arguments.begin(),
                         {"eye", sceneFile("seen_room.toml"), "--width", "16", "-o", file});
        RunningProgram program(arguments);
        REQUIRE(program.waitUntilBusy(kBusySeconds));
        program.signal(SIGINT);
        const Outcome outcome = program.waitForEnd();
        CHECK(outcome.exitCode == 130);
        CHECK(outcome.err == "halfdisk: stopped before the first sample was done; nothing is written\n");
        CHECK(std::filesystem::is_empty(folder.path));
    };
    // Each of these takes minutes, or seconds.
    checkStops({"--estimator", "cast-ray", "--param", "samples=31000"});
    checkStops({"--estimator", "photon-map", "--param", "photons=1e7", "--param", "gather=10000"});
    checkStops({"--estimator", "radiosity", "--param", "patches=4000", "--param", "solver=solve"});
}

TEST_CASE("a second signal ends the program at once") {
    int told[2];
    REQUIRE(pipe(told) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        // As programs begin; the tests' own handlers are not meant.
        signal(SIGINT, SIG_DFL);
        signal(SIGTERM, SIG_DFL);
        const auto tell = [&] { return write(told[1], "!", 1) == 1; };
        const halfdisk::Interruption interruption([&] { tell(); });
        tell();
        while (true) pause();  // as if nobody asked the interruption
    }
    char mark = 0;
    REQUIRE(read(told[0], &mark, 1) == 1);
    kill(child, SIGINT);
    REQUIRE(read(told[0], &mark, 1) == 1);
    kill(child, SIGTERM);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGTERM);
    close(told[0]);
    close(told[1]);
}

TEST_CASE("stopped before the first sample, nothing is measured") {
    const halfdisk::Scene scene = halfdisk::expandScene(halfdisk::loadScene(sceneFile("seen_room.toml")));
    const halfdisk::SegmentIndex index(scene);
    const halfdisk::Sensor sensor = halfdisk::EyeStrip{*scene.eye, 4};
    const halfdisk::EstimatorInfo& path = halfdisk::estimatorArgument("path");
    halfdisk::MeasureLimits limits;
    limits.passes = 10;
    const auto measured = [&](const std::function<bool()>& stop) {
        return halfdisk::measure(path, {index, sensor}, halfdisk::initialValues(path), limits, stop);
    };
    const halfdisk::Measurement stopped = measured([] { return true; });
    CHECK(stopped.interrupted);
    CHECK(stopped.film.passes == 0);
    const halfdisk::Measurement whole = measured({});
    CHECK_FALSE(whole.interrupted);
    CHECK(whole.film.passes == 10);
}

TEST_CASE("a bar with the remaining time on a terminal, not a byte in a pipe") {
    const TemporaryFolder folder;
    const std::vector<std::string> arguments{
        "eye", sceneFile("seen_room.toml"), "--width", "16", "--samples", "2000", "-o", folder / "a.png"};
    const Outcome piped = runProgram(arguments);
    CHECK(piped.exitCode == 0);
    CHECK(piped.err == "");
    const Outcome shown = runOnTerminal(arguments);
    CHECK(shown.exitCode == 0);
    CHECK(shown.err.find("%  ") != std::string::npos);
    CHECK(shown.err.find(" samples") != std::string::npos);
    CHECK(shown.err.find(" left") != std::string::npos);
    CHECK(shown.err.substr(shown.err.size() - 4) == "\r\x1b[K");  // taken away at the end
    CHECK(shown.out.find("written: ") != std::string::npos);
}

TEST_CASE("the bar's text") {
    using halfdisk::durationText;
    using halfdisk::progressLine;
    CHECK(durationText(-1.0) == "0 s");
    CHECK(durationText(0.2) == "1 s");
    CHECK(durationText(59.0) == "59 s");
    CHECK(durationText(59.5) == "1 min 00 s");
    CHECK(durationText(7500.0) == "2 h 05 min");
    CHECK(progressLine(0.25, 5.0, "16 samples") == "[=====               ]  25 %  16 samples  15 s left");
    CHECK(progressLine(1.5, 5.0, "x") == "[====================] 100 %  x  0 s left");
    CHECK(progressLine(0.0, 5.0, "0 samples") == "[                    ]   0 %  0 samples");
}
