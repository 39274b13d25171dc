// Does `halfdisk estimators` tell all that the registry knows, in lines that fit?
#include <doctest/doctest.h>

#include <sstream>

#include "app/estimator_arguments.h"
#include "core/estimators.h"
#include "result_files.h"
#include "run_program.h"

using namespace halfdisk_test;

namespace {

std::string withoutBreaks(const std::string& text) {
    std::string joined, word;
    for (std::istringstream words(text); words >> word;) joined += word + ' ';
    return joined;
}

std::string table(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "estimators");
    const Outcome outcome = runProgram(arguments);
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    return outcome.out;
}

}  // namespace

TEST_CASE("every estimator with its meaning, sensors, bias and parameters") {
    const std::string text = withoutBreaks(table({}));
    const auto check = [&](std::string_view part) {
        CHECK_MESSAGE(text.find(withoutBreaks(std::string(part))) != std::string::npos, part);
    };
    for (const halfdisk::EstimatorInfo* info : halfdisk::estimators()) {
        check(std::string(info->id) + ": " + std::string(info->title));
        check(info->meaning);
        check(info->bias);
        for (const halfdisk::ParamInfo& param : info->params) {
            check(std::string(param.name) + " " + std::string(param.meaning));
            check(", default " + halfdisk::paramText(param, param.initial) + ")");
        }
    }
}

TEST_CASE("no line is wider than 100 columns") {
    for (const std::string& text : {table({}), table({sceneFile("room.toml")})}) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            CHECK_MESSAGE((line.size() <= 100 || line.rfind("Scene: ", 0) == 0), line);
    }
}

TEST_CASE("as JSON: sensors with paths, parameters with range and default") {
    const Json list = Json::parse(table({"--json"}))["estimators"];
    REQUIRE(list.size() == halfdisk::estimators().size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        const halfdisk::EstimatorInfo& info = *halfdisk::estimators()[i];
        CHECK(list[i]["id"] == std::string(info.id));
        CHECK(list[i]["params"].size() == info.params.size());
        for (std::size_t k = 0; k < halfdisk::kSensorNames.size(); ++k) {
            const std::string sensor(halfdisk::kSensorNames[k]);
            CHECK(list[i]["sensors"].contains(sensor) == ((info.sensors >> k) % 2 == 1));
        }
    }
    const Json path = list[1];
    CHECK(path["id"] == "path");
    CHECK(path["params"][0]["choices"].dump() == R"(["sample","hit","both"])");
    CHECK(path["params"][0]["initial"] == "both");
    CHECK(path["params"][3]["most"] == 1000.0);
}

TEST_CASE("in a scene: the paths that are there, and who cannot work") {
    const Json sky = Json::parse(table({sceneFile("open_sky.toml"), "--json"}))["estimators"];
    CHECK(sky[1]["sensors"]["eye"]["paths"] == "LE");
    CHECK(sky[1]["sensors"]["eye"]["refusal"].is_null());
    CHECK(sky[1]["sensors"]["profile"]["refusal"] == "the scene has no wall");
    const Json dark = Json::parse(table({sceneFile("no_light.toml"), "--json"}))["estimators"];
    CHECK(dark[1]["sensors"]["eye"]["paths"] == "none: no light");
    CHECK(runProgram({"estimators", "/nowhere.toml"}).exitCode == 2);
}
