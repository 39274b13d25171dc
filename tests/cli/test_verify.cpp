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
std::string lessonWith(const TemporaryFolder& folder, const std::string& claim,
                       const char* scene = "small_room.toml") {
    std::filesystem::copy_file(shippedScene(scene), folder / "room.toml",
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
    refused("measure = 'rays'\nwith = { params = { samples = 1 } }\nequals = 1\n", "not for cast-ray");
    refused("measure = 'direct'\nwith = { estimator = 'path' }\nequals = 1\n", "only cast-ray");
    refused("measure = 'standardError'\nwith = { repeats = 1 }\nequals = 1\n",
            "standard error of one repeat");
    refused("measure = 'exact'\nwith = { depth = 9 }\nequals = 1\n", "exact E is not known");
    refused("measure = 'rays'\nequals = 'many'\n", "\"equals\" is a string");
    const std::string path = "with = { estimator = 'path', ";
    refused("measure = 'heaviest'\n" + path + "samples = 4 }\nequals = 1\n", "no pixel is named");
    refused("measure = 'heaviest'\n" + path + "pixel = 256 }\nequals = 1\n", "from 0 to 255");
    refused("measure = 'heaviest'\nwith = { pixel = 3 }\nequals = 1\n", "follows no paths");
    refused("measure = 'noise'\n" + path + "picture = 'strip' }\nequals = 1\n", "expected one of \"seen\"");
    refused(
        "measure = 'raysTo'\nwith = { estimator = 'radiosity', wishedError = 0.001, params = { patches = 1 } "
        "}\nequals = 1\n",
        "never comes to an error of 0.001");
    refused("measure = 'planBounces'\nover = { force = { bounces = 0 } }\natLeast = 1e30\n", "which is 0");
    refused("measure = 'planRays'\nwith = { force = { mirrors = true } }\nequals = 1\n",
            "names no requirement");
    refused("measure = 'planRays'\nwith = { force = { colour = false } }\nequals = 1\n", "can't be switched");
    refused("measure = 'planRays'\nwith = { force = { mis = 3 } }\nequals = 1\n", "true or false");
    refused("measure = 'planBounces'\nwith = { force = { bounces = true } }\nequals = 1\n", "\"bounces\"");
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

TEST_CASE(
    "verify: claims about pictures, the trade and the plan agree with the commands that measure these") {
    const TemporaryFolder folder;
    const char* scene = "small_room.toml";
    const auto measured = [&](const std::string& claim) {
        const Outcome outcome =
            runProgram({"verify", lessonWith(folder, claim + "atLeast = 0\n", scene), "--json"});
        INFO(claim, outcome.err);
        REQUIRE(outcome.exitCode == 0);
        return nlohmann::json::parse(outcome.out)["claims"][0]["measured"].get<double>();
    };
    const auto of = [&](const std::string& quantity, const std::string& with) {
        return measured("measure = '" + quantity + "'\nwith = { " + with + " }\n");
    };
    const auto told = [](const std::vector<std::string>& arguments) {
        const Outcome outcome = runProgram(arguments);
        INFO(outcome.err);
        REQUIRE(outcome.exitCode == 0);
        return nlohmann::json::parse(outcome.out);
    };
    const std::string room = shippedScene("small_room.toml");

    SUBCASE("a picture without bias is as far off as its noise says, a smooth one with bias is not") {
        const std::string path = "picture = 'profile', depth = 1, estimator = 'path'";
        const double noise = of("noise", path), error = of("pictureError", path);
        CHECK(error > 0.7 * noise);  // 128 pixels: 6 % one sigma, and neighbours differ
        CHECK(error < 1.4 * noise);
        const std::string patches =
            "picture = 'profile', depth = 1, estimator = 'radiosity', params = { patches = 4 }";
        CHECK(of("pictureError", patches) > 5.0 * of("noise", patches));
    }
    SUBCASE("rays to an error are those of the trade") {
        const auto trade =
            told({"trade", room, "--sensor", "profile", "--walls", "floor", "--depth", "1", "--estimators",
                  "path", "--width", "48", "--rays", "2000000", "--target", "0.02", "--json"});
        const double claimed = of("raysTo", "depth = 1, estimator = 'path', wishedError = 0.02");
        double trades = 0.0;
        for (const auto& cell : trade["cells"])
            if (cell["name"] == "path") trades = cell["byRays"]["toTarget"].get<double>();
        CHECK(claimed == doctest::Approx(trades).epsilon(0.02));
    }
    SUBCASE("scatterings are those of the requirements, unless they are forced") {
        const auto plan = told({"requirements", room, "--sensor", "profile", "--walls", "floor",
                                "--tolerance", "0.02", "--json"});
        CHECK(of("planBounces", "tolerance = 0.02") == plan["plan"]["depth"].get<double>());
        CHECK(of("planBounces", "tolerance = 0.02, force = { bounces = 1 }") == 1.0);
        double tried = 0.0;
        for (const auto& way : plan["tried"])
            if (way["chosen"] == true) tried = way["raysToTolerance"].get<double>();
        CHECK(of("planRays", "tolerance = 0.02") == doctest::Approx(tried).epsilon(0.1));
        CHECK(of("planRays", "tolerance = 0.02, force = { bounces = 0 }") < 0.5 * tried);
    }
    SUBCASE("of one path all light of a pixel comes by the heaviest") {
        scene = "diffuse_room.toml";
        const std::string path = "depth = 2, estimator = 'path', pixel = 100, samples = ";
        CHECK(of("heaviest", path + "1") == 1.0);
        const double among = of("heaviest", path + "64");
        CHECK(among > 1.0 / 64.0);
        CHECK(among < 0.5);
    }
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
