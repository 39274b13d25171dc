#include "probing.h"

#include <doctest/doctest.h>

namespace halfdisk_test {

Outcome probe(const std::string& scene, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"probe", sceneFile(scene)});
    return runProgram(arguments);
}

Json probeJson(const std::string& scene, std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const Outcome outcome = probe(scene, arguments);
    CHECK(outcome.err == "");
    REQUIRE(outcome.exitCode == 0);
    REQUIRE(Json::accept(outcome.out));
    return Json::parse(outcome.out);
}

}  // namespace halfdisk_test
