// Does `halfdisk probe` measure the right thing, and print it in the form that scripts rely on?
#include <doctest/doctest.h>

#include <cmath>
#include <regex>
#include <string>

#include "core/math.h"
#include "probing.h"

using halfdisk::kPi;
using namespace halfdisk_test;

namespace {

/// The bytes without what may differ from run to run.
std::string withoutTimings(const Json& object) {
    Json rest = object;
    rest.erase("seconds");
    rest.erase("threads");
    return rest.dump();
}

std::vector<std::string> keysOf(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

void checkAgrees(const Json& measured, const std::vector<double>& exact, double relativePrecision) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double mean = measured["mean"][i], error = measured["standardError"][i];
        CHECK(error <= relativePrecision * std::abs(exact[i]));
        CHECK_MESSAGE(std::abs(mean - exact[i]) <= kMostStandardErrors * error + 1e-12 * std::abs(exact[i]),
                      mean, " +- ", error, " instead of ", exact[i]);
    }
}

void checkGrey(const Json& measured, double exact, double relativePrecision) {
    checkAgrees(measured, {exact, exact, exact}, relativePrecision);
}

}  // namespace

TEST_CASE("the keys of the JSON object and their order") {
    const Json onWall = probeJson("room.toml", {"--at", "room.0:0.75"});
    CHECK(keysOf(onWall) == std::vector<std::string>{"estimator", "sampler", "samples", "depth", "seed",
                                                     "repeats", "threads", "at", "normal", "irradiance",
                                                     "radiance", "variancePerSample", "rays", "seconds",
                                                     "nonFinite", "emitters"});
    CHECK(keysOf(onWall["irradiance"]) ==
          std::vector<std::string>{"mean", "standardError", "direct", "indirect"});
    CHECK(keysOf(onWall["radiance"]) == std::vector<std::string>{"mean", "standardError"});
    CHECK(onWall["estimator"] == "cast-ray");
    CHECK(onWall["sampler"] == "uniform");
    CHECK(onWall["samples"] == 64);
    CHECK(onWall["depth"] == 1);
    CHECK(onWall["seed"] == 1);
    CHECK(onWall["repeats"] == 16);
    CHECK(onWall["threads"].get<int>() >= 1);
    CHECK(onWall["at"] == Json::array({1.0, 0.0}));
    CHECK(onWall["normal"] == Json::array({0.0, 1.0}));
    CHECK(onWall["nonFinite"] == 0);
    CHECK(onWall["emitters"] == "sample");
    for (std::size_t i = 0; i < 3; ++i) {
        const double total = onWall["irradiance"]["mean"][i], direct = onWall["irradiance"]["direct"][i],
                     indirect = onWall["irradiance"]["indirect"][i];
        CHECK(total == doctest::Approx(direct + indirect).epsilon(1e-12));
    }
}

TEST_CASE("exact case 01: irradiance and radiance from a segment light") {
    const Json tilted = probeJson("segment_light.toml", {"--at", "0.25,0.5", "--normal", "0.6,0.8", "--depth",
                                                         "0", "--samples", "1e4", "--repeat", "32"});
    checkGrey(tilted["irradiance"], 2.836925828919223, 0.005);
    CHECK(tilted["radiance"].is_null());
    const Json floor = probeJson(
        "segment_light.toml", {"--at", "floor:0.525", "--depth", "0", "--samples", "1e4", "--repeat", "32"});
    checkGrey(floor["radiance"], 0.6608417861936788, 0.005);
}

TEST_CASE("every sampler and every way to find emitters gives the same answer") {
    for (const char* sampler : {"uniform", "cosine", "stratified"})
        for (const char* emitters : {"sample", "hit", "both"}) {
            CAPTURE(sampler);
            CAPTURE(emitters);
            const Json floor =
                probeJson("segment_light.toml", {"--at", "floor:0.525", "--depth", "0", "--samples", "1e4",
                                                 "--sampler", sampler, "--emitters", emitters});
            checkGrey(floor["radiance"], 0.6608417861936788, 0.02);
            CHECK(floor["sampler"] == sampler);
            CHECK(floor["emitters"] == emitters);
        }
}

TEST_CASE("a floor under an even sky: E = 2, L = albedo, standard errors scale alike") {
    const Json floor =
        probeJson("lone_floor.toml", {"--at", "floor:0.5", "--depth", "0", "--samples", "1000"});
    checkGrey(floor["irradiance"], 2.0, 0.02);
    checkAgrees(floor["radiance"], {0.8, 0.4, 0.2}, 0.02);
    const double ofE = floor["irradiance"]["standardError"][1], ofL = floor["radiance"]["standardError"][1];
    CHECK(ofL == doctest::Approx(ofE * 0.4 / 2.0).epsilon(1e-12));
    // One uniform sample is pi sin(theta): its second moment is pi^2 / 2.
    CHECK(floor["variancePerSample"][0].get<double>() == doctest::Approx(kPi * kPi / 2 - 4).epsilon(0.05));
}

TEST_CASE("as printed: without the pdf E is 2 / pi, with albedo / pi L is 2 albedo / pi") {
    const Json noPdf = probeJson("open_sky.toml", {"--at", "0,0", "--normal", "1,2", "--depth", "0",
                                                   "--samples", "1000", "--as-printed=pdf"});
    checkGrey(noPdf["irradiance"], 2.0 / kPi, 0.02);
    CHECK(noPdf["asPrinted"] == Json::array({"pdf"}));
    const Json albedo = probeJson(
        "lone_floor.toml", {"--at", "floor:0.5", "--depth", "0", "--samples", "1000", "--as-printed=albedo"});
    checkAgrees(albedo["radiance"], {1.6 / kPi, 0.8 / kPi, 0.4 / kPi}, 0.02);
}

TEST_CASE("as printed without a list switches on every defect and takes no argument for its own") {
    const Json all = probeJson("lone_floor.toml", {"--as-printed", "--at", "floor:0.5"});
    CHECK(all["asPrinted"].size() == 7);
    const Outcome before =
        runProgram({"probe", "--as-printed", sceneFile("lone_floor.toml"), "--at", "floor:0.5"});
    CHECK(before.exitCode == 0);
}

TEST_CASE("the same bytes for any number of threads, others for another seed") {
    // Whole repeats in a chunk, a repeat in several chunks, and neither a whole number of times.
    for (const std::vector<std::string>& sizes :
         {std::vector<std::string>{"7", "1"}, {"64", "1"}, {"2500", "0"}}) {
        const std::string samples = sizes[0], depth = sizes[1];
        CAPTURE(samples);
        const auto run = [&](const char* threads, const char* seed) {
            return probeJson("room.toml",
                             {"--at", "room.0:0.5", "--depth", depth, "--samples", samples, "--repeat", "3",
                              "--emitters", "hit", "--threads", threads, "--seed", seed});
        };
        const Json one = run("1", "5");
        CHECK(one["threads"] == 1);
        CHECK(withoutTimings(run("2", "5")) == withoutTimings(one));
        CHECK(withoutTimings(run("3", "5")) == withoutTimings(one));
        CHECK(run("1", "6")["irradiance"]["mean"] != one["irradiance"]["mean"]);
    }
}

TEST_CASE("only the timings differ in the printed text itself") {
    const auto text = [](const char* threads) {
        const Outcome outcome =
            probe("room.toml", {"--at", "0.25,0.25", "--normal", "1,1", "--json", "--threads", threads});
        return std::regex_replace(outcome.out, std::regex(R"re("(seconds|threads)":[^,]*,)re"), "");
    };
    CHECK(text("1") == text("2"));
}

TEST_CASE("one repeat has no standard error, one sample no variance") {
    const Json repeat = probeJson("room.toml", {"--at", "room.0:0.25", "--repeat", "1"});
    CHECK(repeat["irradiance"]["standardError"].is_null());
    CHECK(repeat["radiance"]["standardError"].is_null());
    CHECK(repeat["radiance"]["mean"].is_array());
    CHECK(repeat["variancePerSample"].is_array());
    const Json sample = probeJson("room.toml", {"--at", "room.0:0.25", "--repeat", "1", "--samples", "1"});
    CHECK(sample["variancePerSample"].is_null());
    const Json stratified = probeJson("room.toml", {"--at", "room.0:0.25", "--sampler", "stratified"});
    CHECK(stratified["variancePerSample"].is_null());
    CHECK(stratified["irradiance"]["standardError"].is_array());
}

TEST_CASE("a wall point by name is the same as by coordinates") {
    const Json byName = probeJson("room.toml", {"--at", "room.0:0.75"});
    const Json byPoint = probeJson("room.toml", {"--at", "1,0"});
    CHECK(withoutTimings(byName) == withoutTimings(byPoint));
    const Json tilted = probeJson("room.toml", {"--at", "room.0:0.75", "--normal", "1,1"});
    CHECK(tilted["at"] == byName["at"]);
    CHECK(tilted["radiance"].is_null());
    CHECK(tilted["normal"] != byName["normal"]);
}

TEST_CASE("an emitting wall sends out its own light at depth 0 already") {
    const Json lamp = probeJson("room.toml", {"--at", "lamp:0.5", "--depth", "0"});
    CHECK(lamp["normal"] == Json::array({0.0, -1.0}));
    CHECK(lamp["radiance"]["mean"][0].get<double>() > 3.0);
}

TEST_CASE("more than 10^10 rays are refused with their count, unless the user insists") {
    const std::vector<std::string> tooMany{"--at", "0,0", "--normal", "0,1", "--samples", "1e5", "--json"};
    const Outcome refused = probe("open_sky.toml", tooMany);
    CHECK(refused.exitCode == 2);
    CHECK(refused.out == "");
    CHECK(refused.err.find("1.6e+11 rays") != std::string::npos);
    CHECK(refused.err.find("--anyway") != std::string::npos);
    // Every ray of these leaves the empty scene, so few are cast in the end.
    std::vector<std::string> anyway = tooMany;
    anyway.push_back("--anyway");
    const Outcome insisted = probe("open_sky.toml", anyway);
    CHECK(insisted.exitCode == 0);
    CHECK(Json::parse(insisted.out)["rays"] == 1'600'000);
    const Outcome endless = probe("room.toml", {"--at", "lamp:0.5", "--samples", "1e9", "--depth", "64"});
    CHECK(endless.exitCode == 2);
    CHECK(endless.err.find("more than 1e300 rays") != std::string::npos);
}
