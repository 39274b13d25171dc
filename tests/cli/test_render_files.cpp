// Do the files of a rendering say the same, each in its own form?
#include <doctest/doctest.h>

#include <cmath>

#include "app/pfm_image.h"
#include "app/png_image.h"
#include "app/tone.h"
#include "result_files.h"
#include "run_program.h"

using namespace halfdisk_test;
using halfdisk::Rgb;

namespace {

struct Written {
    CsvFile csv;
    Json json;
    halfdisk::LinearImage pfm;
    halfdisk::Image png;
    Json summary;
};

/// All four files of one run, with the summary as JSON.
Written render(std::vector<std::string> arguments) {
    const TemporaryFolder folder;
    const auto file = [&](const char* extension) { return folder / (std::string("a.") + extension); };
    for (const char* extension : {"csv", "json", "pfm", "png"}) {
        arguments.push_back("-o");
        arguments.push_back(file(extension));
    }
    arguments.push_back("--json");
    const Outcome outcome = runProgram(arguments);
    CHECK(outcome.err == "");
    REQUIRE(outcome.exitCode == 0);
    return {readCsv(file("csv")), readJson(file("json")), halfdisk::decodePfm(readFile(file("pfm"))),
            halfdisk::readPng(file("png")), Json::parse(outcome.out)};
}

Rgb rgbOf(const Json& array) {
    return {array[0].get<double>(), array[1].get<double>(), array[2].get<double>()};
}

/// Every pixel of every file, `height` rows of the same if the sensor has only one.
void checkFilesAgree(const Written& files) {
    const std::size_t pixels = files.csv.rows.size();
    REQUIRE(files.json["mean"].size() == pixels);
    REQUIRE(files.json["standardError"].size() == pixels);
    REQUIRE(files.pfm.pixels.size() % pixels == 0);
    REQUIRE(files.png.width == static_cast<int>(files.pfm.width));
    REQUIRE(files.png.height == static_cast<int>(files.pfm.height));
    const double scale = std::exp2(files.json["exposure"].get<double>());
    std::size_t different = 0;
    for (std::size_t i = 0; i < files.pfm.pixels.size(); ++i) {
        const CsvRow& row = files.csv.rows[i % pixels];
        if (rgbOf(files.json["mean"][i % pixels]) != row.mean) ++different;
        if (rgbOf(files.json["standardError"][i % pixels]) != row.error) ++different;
        for (int c = 0; c < 3; ++c) {
            if (files.pfm.pixels[i][c] != static_cast<double>(static_cast<float>(row.mean[c]))) ++different;
            const int level = halfdisk::srgbByte(scale * row.mean[c]);
            const auto at = 4 * i + static_cast<std::size_t>(c);
            if (std::abs(files.png.rgba[at] - level) > 1) ++different;
        }
    }
    CHECK(different == 0);
    for (const auto& fact : files.csv.facts)
        if (fact.first != "seconds") CHECK(files.json[fact.first].dump() == fact.second);
    CHECK(files.csv.facts.size() + 2 == files.json.size());
}

double brightest(const Written& files) {
    double most = 0.0;
    for (const CsvRow& row : files.csv.rows) most = std::max({most, row.mean.x, row.mean.y, row.mean.z});
    return most;
}

}  // namespace

TEST_CASE("eye: CSV, JSON, PFM and PNG hold the same pixels and facts") {
    const Written files =
        render({"eye", sceneFile("seen_room.toml"), "--width", "40", "--height", "3", "--samples", "9",
                "--param", "roulette=2", "--seed", "7", "--depth", "2", "--specular", "5", "--threads", "2"});
    checkFilesAgree(files);
    CHECK(files.csv.columns ==
          std::vector<std::string>{"pixel", "angle", "r", "g", "b", "errorR", "errorG", "errorB"});
    CHECK(files.pfm.height == 3);
    CHECK(files.csv.rows.size() == 40);
    CHECK(brightest(files) > 0.0);
    const Json& facts = files.json;
    CHECK(facts["scene"] == sceneFile("seen_room.toml"));
    CHECK(facts["sensor"] == "eye");
    CHECK(facts["eye"]["fov"].get<double>() == doctest::Approx(100.0).epsilon(1e-12));
    CHECK(facts["unit"] == "W/(m rad)");
    CHECK(facts["estimator"] == "path");
    CHECK(facts["parameters"]["roulette"] == 2);
    CHECK(facts["parameters"]["emitters"] == "both");
    CHECK(facts["samples"] == 9);
    CHECK(facts["depth"] == 2);
    CHECK(facts["specular"] == 5);
    CHECK(facts["seed"] == 7);
    CHECK(facts["rays"].get<int>() > 40 * 9);
    CHECK(facts["paths"] == 40 * 9);
    CHECK(facts["cut"] == 0);
    CHECK(facts["nonFinite"] == 0);
    CHECK(facts["negative"] == 0);
}

TEST_CASE("profile: bins of several walls, one after the other") {
    const Written files = render({"profile", sceneFile("seen_room.toml"), "--walls", "block,lamp", "--width",
                                  "21", "--estimator", "light", "--samples", "50"});
    checkFilesAgree(files);
    CHECK(files.json["profile"]["walls"].dump() == R"(["block.0","block.1","block.2","block.3","lamp"])");
    CHECK(files.json["profile"]["length"].get<double>() == doctest::Approx(4 * 0.4 + 0.5).epsilon(1e-12));
    CHECK(files.json["unit"] == "W/m");
    REQUIRE(files.csv.rows.size() == 21);
    for (std::size_t i = 0; i < 21; ++i)
        CHECK(files.csv.rows[i].place[0] ==
              doctest::Approx((static_cast<double>(i) + 0.5) * 0.1).epsilon(1e-12));
}

TEST_CASE("field: rows from the top, cells around the scene by default") {
    const Written files = render({"field", sceneFile("room.toml"), "--width", "22", "--samples", "4"});
    checkFilesAgree(files);
    // The room is 4 x 2 m; the margin 5 % of 4 m: 4.4 x 2.4 m.
    CHECK(files.pfm.width == 22);
    CHECK(files.pfm.height == 12);
    CHECK(files.json["field"]["min"].dump() == "[-2.2,-0.2]");
    const CsvRow &first = files.csv.rows.front(), &last = files.csv.rows.back();
    CHECK(first.place[0] == doctest::Approx(-2.1).epsilon(1e-12));
    CHECK(first.place[1] == doctest::Approx(2.1).epsilon(1e-12));
    CHECK(last.place[0] == doctest::Approx(2.1).epsilon(1e-12));
    CHECK(last.place[1] == doctest::Approx(-0.1).epsilon(1e-12));
}

TEST_CASE("the summary tells the facts of the files, and what all pixels say together") {
    const Written files = render({"eye", sceneFile("seen_room.toml"), "--width", "30", "--samples", "16"});
    Rgb sum{0.0};
    for (const CsvRow& row : files.csv.rows) sum += row.mean / 30.0;
    for (int c = 0; c < 3; ++c)
        CHECK(rgbOf(files.summary["mean"])[c] == doctest::Approx(sum[c]).epsilon(1e-12));
    CHECK(files.summary["litPixels"] == 30);
    CHECK(files.summary["relativeError"].get<double>() > 0.0);
    CHECK(files.summary["stopped"] == false);
    CHECK(files.summary["files"].size() == 4);
    CHECK(files.summary["command"] == files.json["command"]);
    CHECK_FALSE(files.summary.contains("standardError"));
}

TEST_CASE("one sample has no standard error") {
    const TemporaryFolder folder;
    const std::string csv = folder / "a.csv", json = folder / "a.json";
    REQUIRE(runProgram(
                {"eye", sceneFile("seen_room.toml"), "--samples", "1", "--width", "2", "-o", csv, "-o", json})
                .exitCode == 0);
    CHECK(readJson(json)["standardError"].dump() == "[null,null]");
    CHECK(readCsv(csv).rows[1].error == Rgb(-1.0));
}

TEST_CASE("a scene without light is black, and that is no error") {
    const Written files = render({"eye", sceneFile("no_light.toml"), "--width", "5", "--height", "1"});
    checkFilesAgree(files);
    CHECK(brightest(files) == 0.0);
    CHECK(files.json["exposure"] == 0.0);
    CHECK(files.summary["relativeError"].is_null());
}

TEST_CASE("the exposure that is asked for is the one of the picture") {
    const Written files = render({"eye", sceneFile("seen_room.toml"), "--width", "8", "--exposure", "-1.5"});
    CHECK(files.json["exposure"].get<double>() == doctest::Approx(-1.5).epsilon(1e-12));
    checkFilesAgree(files);
}

TEST_CASE("the summary for people has units, counts and files") {
    const TemporaryFolder folder;
    const std::string file = folder / "a.png";
    const Outcome outcome = runProgram({"eye", sceneFile("seen_room.toml"), "--width", "8", "-o", file});
    for (const char* part :
         {"path, 64 samples, depth 1, specular 32, seed 1", "roulette = 4", "W/(m rad)", "8 pixels",
          "relative standard errors", "Mrays/s", "0 contributions not finite, 0 negative", "EV", "written: "})
        CHECK_MESSAGE(outcome.out.find(part) != std::string::npos, part);
    CHECK(outcome.out.find(file) != std::string::npos);
}
