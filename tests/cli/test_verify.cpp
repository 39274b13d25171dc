// Does `halfdisk verify` tell true claims from false ones, with their places?
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lessons/lesson_file.h"
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

TEST_CASE("verify: LESSON:STEP measures the claims of that step alone") {
    const auto count = [](const std::string& lesson) {
        const Outcome outcome = runProgram({"verify", lesson, "--json"});
        REQUIRE(outcome.exitCode == 0);
        return nlohmann::json::parse(outcome.out)["claims"];
    };
    const auto all = count("notation");
    std::size_t ofSecond = 0;
    for (const auto& claim : all) ofSecond += claim["step"] == 2;
    const auto second = count("notation:2");
    CHECK(second.size() == ofSecond);
    CHECK(second.size() < all.size());
    for (const auto& claim : second) CHECK(claim["step"] == 2);
    CHECK(runProgram({"verify", "notation:99"}).exitCode == 2);
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

TEST_CASE("verify: one number changed in a lesson changes its text and is found out") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "scenes");
    std::filesystem::copy_file(shippedScene("open_court.toml"), folder / "scenes" / "open_court.toml");
    const std::filesystem::path file = folder / "21-requirements.toml";
    std::ifstream stream(std::filesystem::path(HALFDISK_SHIPPED_SCENES).parent_path() /
                         "21-requirements.toml");
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    const auto writeLesson = [&] { std::ofstream(file) << text; };
    const auto firstText = [&] { return halfdisk::plainText(halfdisk::loadLesson(file).steps.at(0).prose); };

    writeLesson();
    CHECK(runProgram({"verify", file.string()}).exitCode == 0);
    CHECK(firstText().find("2 · sin 14° = 0.485") != std::string::npos);

    const std::string number = "equals = 0.4850";
    const std::size_t at = text.find(number);
    REQUIRE(at != std::string::npos);
    text.replace(at, number.size(), "equals = 0.4950");
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    writeLesson();
    CHECK(firstText().find("2 · sin 14° = 0.495") != std::string::npos);
    const Outcome outcome = runProgram({"verify", file.string()});
    CHECK(outcome.exitCode == 1);
    INFO(outcome.err);
    CHECK(outcome.err.find(file.string() + ":" + std::to_string(line) + ":10: not true: \"") == 0);
    CHECK(outcome.err.find("2 sin 14° = 0.495") != std::string::npos);
    CHECK(outcome.err.find("exact is 0.485071") != std::string::npos);
}

TEST_CASE("verify: numbers that are typed in bold are listed when asked for") {
    const TemporaryFolder folder;
    const std::string file =
        lessonWith(folder,
                   "name = 'none'\nmeasure = 'nonFinite'\nequals = 0\n"
                   "[[step]]\ntitle = 'B'\nprose = 'There are **{none}**, not **12**.'\n");
    const Outcome plain = runProgram({"verify", file});
    CHECK(plain.exitCode == 0);
    CHECK(plain.out.find("typed") == std::string::npos);
    const Outcome listed = runProgram({"verify", file, "--prose"});
    CHECK(listed.exitCode == 0);
    CHECK(listed.out.find("typed " + file + ":17:36: 12\n") != std::string::npos);
    CHECK(listed.out.find("1 number stands in bold as typed") != std::string::npos);
    const auto object = nlohmann::json::parse(runProgram({"verify", file, "--prose", "--json"}).out);
    CHECK(object["typed"].size() == 1);
    CHECK(object["typed"][0]["words"] == "12");
    CHECK(object["claims"][0]["name"] == "none");
}

TEST_CASE("verify: the spread is the root of the variance, and the relative error what one run has") {
    const TemporaryFolder folder;
    const auto measured = [&](const std::string& quantity) {
        const Outcome outcome = runProgram(
            {"verify", "--json",
             lessonWith(folder, "measure = '" + quantity + "'\nwith = { repeats = 100 }\nequals = 0\n")});
        return nlohmann::json::parse(outcome.out)["claims"][0]["measured"].get<double>();
    };
    const double variance = measured("variance");
    CHECK(measured("spread") == doctest::Approx(std::sqrt(variance)));
    // A run has 4 samples.
    CHECK(measured("relativeError") == doctest::Approx(std::sqrt(variance / 4) / measured("irradiance")));
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
