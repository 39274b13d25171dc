// Does `halfdisk probe` ask every estimator of the registry, do they agree with castRay, and what is printed
// of it for people?
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "core/estimators.h"
#include "probing.h"
#include "refusals.h"

using namespace halfdisk_test;

namespace {

/// Two independent measurements of the same, each good to 5 %.
void checkAgree(const Json& a, const Json& b) {
    for (std::size_t c = 0; c < 3; ++c) {
        const double meanA = a["mean"][c], meanB = b["mean"][c], errorA = a["standardError"][c],
                     errorB = b["standardError"][c];
        CHECK(errorA <= 0.05 * meanA);
        CHECK(errorB <= 0.05 * meanB);
        CHECK_MESSAGE(std::abs(meanA - meanB) <= kMostStandardErrors * std::hypot(errorA, errorB), meanA,
                      " +- ", errorA, " and ", meanB, " +- ", errorB);
    }
}

void checkPassesRefused(std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"probe", sceneFile("room.toml"), "--at", "room.0:0.75"});
    checkRefused(options, message);
}

}  // namespace

TEST_CASE("path and light agree with castRay: irradiance, and radiance of the wall") {
    const std::vector<std::string> place{"--at", "room.0:0.8", "--depth", "2"};
    const auto ask = [&](std::vector<std::string> options) {
        options.insert(options.end(), place.begin(), place.end());
        return probeJson("room.toml", options);
    };
    const Json castRay = ask({"--samples", "16", "--repeat", "400"});
    for (const char* estimator : {"path", "light", "bidirectional"}) {
        CAPTURE(estimator);
        const Json other = ask({"--estimator", estimator, "--samples", "40000", "--seed", "3"});
        checkAgree(other["irradiance"], castRay["irradiance"]);
        checkAgree(other["radiance"], castRay["radiance"]);
        CHECK(other["at"] == castRay["at"]);
        CHECK(other["normal"] == castRay["normal"]);
        CHECK(other["samples"] == 40000);
        CHECK(other["estimator"] == estimator);
    }
}

TEST_CASE("a look: radiance that arrives along one ray, by path and by castRay") {
    const std::vector<std::string> ray{"--at", "-1.75,0.25", "--look", "2,1", "--depth", "1"};
    const auto ask = [&](std::vector<std::string> options) {
        options.insert(options.end(), ray.begin(), ray.end());
        return probeJson("room.toml", options);
    };
    const Json castRay = ask({"--samples", "16", "--repeat", "400"});
    const Json path = ask({"--estimator", "path", "--samples", "40000"});
    checkAgree(path["radiance"], castRay["radiance"]);
    CHECK(path["irradiance"].is_null());
    CHECK_FALSE(path.contains("normal"));
    CHECK(castRay["repeats"] == 400);
    CHECK(castRay["parameters"]["samples"] == 16);
}

TEST_CASE("a look from a wall starts on the side that it goes to") {
    // Up from the floor into the lamp, which has radiance 3.
    const Json lamp = probeJson("segment_light.toml", {"--at", "floor:0.525", "--look", "0,1", "--depth", "0",
                                                       "--estimator", "path", "--samples", "2"});
    CHECK(lamp["radiance"]["mean"][0] == 3.0);
    const Json below = probeJson("segment_light.toml", {"--at", "floor:0.525", "--look", "0,-1", "--depth",
                                                        "0", "--estimator", "path", "--samples", "2"});
    CHECK(below["radiance"]["mean"][0] == 0.0);
}

TEST_CASE("the listed values are those that the mean is made of") {
    for (const std::string estimator : {"cast-ray", "path"}) {
        CAPTURE(estimator);
        const char* count = estimator == "path" ? "--samples" : "--repeat";
        const Json answer = probeJson("room.toml", {"--at", "room.0:0.8", "--estimator", estimator, count,
                                                    "5000", "--list", "--threads", "2"});
        REQUIRE(answer["values"].size() == 5000);
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0.0;
            for (const Json& value : answer["values"]) sum += value[c].get<double>();
            CHECK(answer["irradiance"]["mean"][c].get<double>() ==
                  doctest::Approx(sum / 5000).epsilon(1e-12));
        }
        const std::set<Json> different(answer["values"].begin(), answer["values"].end());
        CHECK(different.size() > 100);
    }
    CHECK_FALSE(probeJson("room.toml", {"--at", "room.0:0.8"}).contains("values"));
}

TEST_CASE("the table for people tells the units and the exact answer, however bright the light") {
    const Outcome small = probe("segment_light.toml", {"--at", "floor:0.525", "--depth", "0"});
    CHECK(small.exitCode == 0);
    for (const char* part :
         {"irradiance", "W/m", "standard error", "direct", "indirect", "radiance", "W/(m rad)", "variance",
          "rays/s", "0 samples not finite", "on wall \"floor\"", "std. errors", "2.64337"})
        CHECK_MESSAGE(small.out.find(part) != std::string::npos, part);
    const Outcome depth2 =
        probe("segment_light.toml", {"--at", "floor:0.525", "--depth", "2", "--samples", "4"});
    CHECK(depth2.out.find("exact") == std::string::npos);
    const Outcome printed = probe("segment_light.toml", {"--at", "floor:0.525", "--as-printed=pdf"});
    CHECK(printed.out.find("exact") == std::string::npos);
    CHECK(printed.out.find("as printed: pdf") != std::string::npos);
}

TEST_CASE("the table of a probe by passes has the exact answer where it is known") {
    const Outcome outcome = probe("segment_light.toml", {"--at", "floor:0.525", "--depth", "0", "--estimator",
                                                         "path", "--samples", "1000"});
    CHECK(outcome.exitCode == 0);
    for (const char* part : {"path, 1000 samples", "irradiance", "exact E", "2.64337", "std. errors",
                             "radiance leaving the wall", "0 contributions not finite"})
        CHECK_MESSAGE(outcome.out.find(part) != std::string::npos, part);
}

TEST_CASE("refused: options that do not belong together") {
    checkPassesRefused({"--estimator", "path", "--repeat", "2"},
                       "halfdisk: --repeat is for cast-ray only; path has independent --samples\n");
    checkPassesRefused({"--estimator", "path", "--sampler", "cosine"},
                       "--sampler is for cast-ray only; path has");
    checkPassesRefused({"--estimator", "path", "--emitters", "hit"},
                       "--emitters is for cast-ray only; path has");
    checkPassesRefused({"--estimator", "path", "--as-printed"},
                       "--as-printed is for cast-ray only; path has no");
    checkPassesRefused({"--param", "samples=2"},
                       "halfdisk: --param: 'samples=2' is not for cast-ray, whose options are --samples");
    checkPassesRefused({"--estimator", "path", "--param", "x=2"}, "'x=2' names no parameter of path");
    checkPassesRefused({"--normal", "0,1", "--look", "0,1"}, "--normal and --look exclude each other");
    checkPassesRefused({"--look", "0,0"}, "halfdisk: --look: '0,0' has no direction");
    checkPassesRefused({"--look", "0,1", "--as-printed"}, "no way to look along one ray\n");
    checkPassesRefused({"--list"}, "halfdisk: --list: values are a part of the JSON object, add --json\n");
    checkPassesRefused({"--list", "--json", "--repeat", "10001"},
                       "halfdisk: --list: 10001 values are too many, expected at most 10000\n");
    checkPassesRefused({"--estimator", "path", "--samples", "0"},
                       "--samples: '0' is not a whole number from 1");
    checkPassesRefused({"--estimator", "path", "--specular", "-1"}, "--specular: '-1' is not a whole number");
    checkPassesRefused({"--look", "0,1", "--samples", "1e5", "--depth", "2"}, "more than 10^10");
}
