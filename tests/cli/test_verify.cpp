// Does `halfdisk verify` tell true claims from false ones, with their places?
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "run_program.h"

using namespace halfdisk_test;

namespace {

/// A teacher's own lesson over a shipped scene, with this claim.
std::string lessonWith(const TemporaryFolder& folder, const std::string& claim) {
    std::filesystem::copy_file(shippedScene("small_room.toml"), folder / "room.toml",
                               std::filesystem::copy_options::overwrite_existing);
    const std::string file = (folder / "01-mine.toml").string();
    std::ofstream(file) << "title = 'Mine'\nsection = 'S'\nscene = 'room.toml'\n"
                           "[[step]]\ntitle = 'A'\nprose = 'B'\n[step.set]\nat = 'floor:0.4'\nsamples = 4\n"
                           "[[step.claim]]\nsays = 'What I say'\n"
                        << claim;
    return file;
}

}  // namespace

TEST_CASE("verify: a teacher's own claim, true and false") {
    const TemporaryFolder folder;
    const std::string claim =
        "measure = 'standardError'\nwith = { repeats = 2000 }\nover = { samples = 16 }\n";
    const Outcome held = runProgram({"verify", lessonWith(folder, claim + "equals = 2\ntolerance = 0.2\n")});
    CHECK(held.exitCode == 0);
    CHECK(held.err.empty());
    CHECK(held.out.find("true  mine:1  What I say") == 0);
    CHECK(held.out.find("1 claim, 1 of them true") != std::string::npos);

    const std::string file = lessonWith(folder, claim + "equals = 3\ntolerance = 0.2\n");
    const Outcome failed = runProgram({"verify", file});
    CHECK(failed.exitCode == 1);
    CHECK(failed.err.find(file + ":15:10: not true: \"What I say\": standardError is ") == 0);
    CHECK(failed.err.find("expected 3 +- 0.2") != std::string::npos);
    CHECK(failed.out == "1 claim, 0 of them true\n");
}

TEST_CASE("verify: the same on any number of threads, and as JSON") {
    const TemporaryFolder folder;
    const std::string file =
        lessonWith(folder, "measure = 'irradiance'\nwith = { repeats = 64 }\natLeast = 0\n");
    const auto measured = [&](const char* threads) {
        const Outcome outcome = runProgram({"verify", file, "--json", "--threads", threads});
        CHECK(outcome.exitCode == 0);
        const auto object = nlohmann::json::parse(outcome.out);
        CHECK(object["held"] == 1);
        CHECK(object["failed"] == 0);
        CHECK(object["claims"][0]["line"] == 14);
        return object["claims"][0]["measured"].get<double>();
    };
    CHECK(measured("1") == measured("3"));
}

TEST_CASE("verify: what can't be measured is refused with its place") {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& claim, const std::string& said) {
        const std::string file = lessonWith(folder, claim);
        const Outcome outcome = runProgram({"verify", file});
        CHECK(outcome.exitCode == 2);
        CHECK(outcome.err.find(file) == 0);
        INFO(outcome.err);
        CHECK(outcome.err.find(said) != std::string::npos);
    };
    refused("measure = 'rays'\nwith = { estimator = 'photon' }\nequals = 1\n", "photon-map");
    refused("measure = 'rays'\nwith = { params = { gather = 1 } }\nequals = 1\n", "not for cast-ray");
    refused("measure = 'direct'\nwith = { estimator = 'path' }\nequals = 1\n", "only cast-ray");
    refused("measure = 'standardError'\nwith = { repeats = 1 }\nequals = 1\n",
            "standard error of one repeat");
    refused("measure = 'exact'\nwith = { depth = 9 }\nequals = 1\n", "exact E is not known");
    refused("measure = 'rays'\nequals = 'many'\n", "\"equals\" is a string");
    CHECK(runProgram({"verify", "no-such-lesson"}).exitCode == 2);
}

TEST_CASE("verify: every claim of the shipped lessons is true") {
#ifdef __SANITIZE_ADDRESS__
    // Twenty times as slow; one lesson of many estimators shows as much of the memory.
    const Outcome outcome = runProgram({"verify", "notation"});
#else
    const Outcome outcome = runProgram({"verify"});
#endif
    INFO(outcome.err);
    CHECK(outcome.exitCode == 0);
}
