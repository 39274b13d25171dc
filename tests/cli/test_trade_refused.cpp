// Is a trade that makes no sense refused before any work, with exit code 2 and one clear line?
#include <doctest/doctest.h>

#include <sys/stat.h>

#include <fstream>

#include "refusals.h"
#include "result_files.h"
#include "run_program.h"

using namespace halfdisk_test;
namespace fs = std::filesystem;

namespace {

void checkTradeRefused(std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"trade", shippedScene("diffuse_room.toml")});
    checkRefused(options, message);
}

}  // namespace

TEST_CASE("trade refused: no scene, and numbers that are none") {
    checkRefused({"trade"}, "trade needs a scene file");
    checkTradeRefused({"--budget", "0"}, "--budget");
    checkTradeRefused({"--budget", "1", "--rays", "1000"}, "exclude each other");
    checkTradeRefused({"--rays", "many"}, "--rays");
    checkTradeRefused({"--target", "2"}, "--target");
    checkTradeRefused({"--depth", "-1"}, "--depth");
}

TEST_CASE("trade refused: estimators and sweeps") {
    checkTradeRefused({"--estimators", "pth"}, "path");
    checkTradeRefused({"--estimators", "path,path"}, "names path twice");
    checkTradeRefused({"--sweep", "patches"}, "is no sweep, expected KEY=VALUE,VALUE");
    checkTradeRefused({"--sweep", "patches=1,"}, "has an empty value");
    checkTradeRefused({"--sweep", "patches=10,10"}, "has '10' twice");
    checkTradeRefused({"--sweep", "patches=10", "--sweep", "patches=20"}, "expected all values in one list");
    checkTradeRefused({"--estimators", "path", "--sweep", "patches=10,20"}, "none of the estimators has");
    checkTradeRefused({"--sweep", "radiosity.patches=0"}, "patches");
    checkTradeRefused({"--sweep", "facets=0"}, "facets");
    checkTradeRefused({"--sweep", "index=fast"}, "every wall");
    checkTradeRefused({"--sweep", "precision=half"}, "expected one of \"float\" or \"double\"");
    checkTradeRefused({"--sweep", "precision=float,double", "--sweep", "index=automatic,tree"},
                      "'precision=float,double' does not go with index=automatic,tree");
    checkTradeRefused({"--sweep", "path.index=grid", "--sweep", "precision=float"}, "does not go with");
    checkTradeRefused({"--sweep", "index=single", "--sweep", "precision=double"}, "does not go with");
    checkTradeRefused({"--sweep", "photon-map.shrink=0.5"}, "passes then are not alike");
}

TEST_CASE("trade refused: sensors, parts and references") {
    checkTradeRefused({"--sensor", "look"}, "expected one of eye, profile, field, probe");
    checkTradeRefused({"--sensor", "probe"}, "expected --at");
    checkTradeRefused({"--sensor", "eye", "--walls", "floor"}, "--walls is for --sensor profile only");
    checkTradeRefused({"--sensor", "field", "--width", "1000"}, "too many for 32 pictures");
    checkTradeRefused({"--part", "0/4", "-o", "x"}, "is no part, expected I/N");
    checkTradeRefused({"--part", "1/4"}, "expected -o DIR");
    checkTradeRefused({"--reference", "/no/such/file.json"}, "/no/such/file.json: cannot be read");
    const TemporaryFolder folder;
    checkTradeRefused({"--reference", folder.path.string()}, "this is a directory");
    const std::string file = folder / "x.json";
    std::ofstream(file) << "{\"mean\": 3}";
    checkTradeRefused({"--reference", file}, "is not what halfdisk eye, profile or field wrote");
    // Light of a lamp without size, through glass, to an eye: nobody carries it all.
    std::ofstream(folder / "s.toml")
        << "[material.glass]\ntype = 'dielectric'\n[[circle]]\ncenter = [0.0, 1.0]\nradius = 0.3\n"
           "segments = 16\nmaterial = 'glass'\n[[segment]]\nname = 'floor'\na = [-1.0, 0.0]\nb = "
           "[1.0, 0.0]\n[[light]]\ntype = 'point'\nposition = [0.0, 2.0]\n[eye]\nposition = [1.0, "
           "1.0]\ndirection = [-1.0, -0.5]\n";
    checkRefused({"trade", folder / "s.toml", "--rays", "100"},
                 "expected --reference FILE, or another --sensor");
}

TEST_CASE("trade refused: pictures that can't be a reference") {
    const TemporaryFolder folder;
    const std::string file = folder / "x.json", scene = shippedScene("mirror_room.toml");
    REQUIRE(
        runProgram({"eye", scene, "--width", "4", "--depth", "3", "--samples", "8", "-o", file}).exitCode ==
        0);
    const Json picture = Json::parse(readFile(file));
    const auto checkFile = [&](const std::string& pointer, const Json& value, const std::string& message) {
        Json changed = picture;
        changed.at(Json::json_pointer(pointer)) = value;
        std::ofstream(file) << changed;
        checkRefused({"trade", scene, "--width", "4", "--depth", "3", "--rays", "100", "--reference", file},
                     message);
    };
    checkFile("/standardError", nullptr, "has pixels without standard error");
    checkFile("/standardError", Json::array(), "has pixels without standard error");
    checkFile("/standardError/1", nullptr, "has pixels without standard error");
    checkFile("/mean/0/1", -1.0, "has a pixel below zero");
    checkFile("/mean/0/1", nullptr, "is not what halfdisk eye, profile or field wrote");
}

TEST_CASE("trade refused: folders that hold something else") {
    const TemporaryFolder folder;
    const std::string out = folder / "room";
    const std::vector<std::string> small{"trade",        shippedScene("diffuse_room.toml"),
                                         "--width",      "4",
                                         "--rays",       "200",
                                         "--estimators", "path",
                                         "--sweep",      "emitters=hit,both",
                                         "-o",           out};
    REQUIRE(runProgram(small).exitCode == 0);
    std::vector<std::string> other = small;
    other[5] = "300";
    checkRefused(other, "answers another question: its rays is 200.0, not 300.0");
    other = small;
    other[9] = "emitters=hit";
    checkRefused(other, "it compares other settings");
    checkRefused({"trade", "merge", folder / "nothing", "-o", folder / "all"}, "holds no cells");
    std::ofstream(folder / "room" / "cells" / "0001.json") << "{\"half\":";
    checkRefused(small, "0001.json: is damaged, or not what halfdisk trade wrote");
    checkRefused({"trade", "merge", folder / "room", "-o", folder / "all"}, "delete it");
}

TEST_CASE("trade refused: what a folder holds is not believed blindly") {
    const TemporaryFolder folder;
    const std::string out = folder / "room";
    const std::vector<std::string> small{"trade",        shippedScene("mirror_room.toml"),
                                         "--width",      "4",
                                         "--rays",       "2000",
                                         "--estimators", "path",
                                         "--sweep",      "roulette=0,4",
                                         "-o",           out};
    REQUIRE(runProgram(small).exitCode == 0);
    const auto checkDamaged = [&](const std::string& file, const std::string& pointer, const Json& value) {
        const fs::path path = fs::path(out) / file;
        const std::string kept = readFile(path);
        Json json = Json::parse(kept);
        json.at(Json::json_pointer(pointer)) = value;
        std::ofstream(path) << json;
        INFO(file << pointer << " = " << value.dump());
        checkRefused(small, path.filename().string() + ": ");
        std::ofstream(path) << kept;
    };
    const std::string cell = "cells/0001.json";
    for (const Json& value : {Json(0), Json(-1), Json(1.5), Json("x"), Json(nullptr)})
        checkDamaged(cell, "/cell/passes", value);
    for (const char* key : {"depth", "rays", "noise", "groupMse", "seconds", "unseen"})
        for (const Json& value : {Json(-1), Json(1e308), Json(nullptr)})
            checkDamaged(cell, std::string("/cell/") + key, value);
    checkDamaged(cell, "/cell/params/0", 1e18);
    checkDamaged(cell, "/number", 0);
    checkDamaged(cell, "/number", 99);
    checkDamaged(cell, "/truth/light", 1e18);
    checkDamaged(cell, "/target", 0.06);
    checkDamaged(cell, "/fingerprint", "0123456789abcdef");
    for (const char* place : {"/mean/0/0", "/standardError", "/relativeError", "/groups/0/0/1", "/groups/0"})
        for (const Json& value : {Json(-1e-9), Json(1e308), Json(nullptr), Json("x")})
            checkDamaged("reference.json", place, value);
    // What is no file: nobody waits for it.
    fs::remove(fs::path(out) / cell);
    REQUIRE(::mkfifo((fs::path(out) / cell).c_str(), 0600) == 0);
    checkRefused(small, "0001.json: is no file that can be read");
    // A folder where a file should be.
    fs::remove(fs::path(out) / cell);
    fs::create_directory(fs::path(out) / cell);
    checkRefused(small, "0001.json: is a folder");
    fs::remove(fs::path(out) / cell);
    CHECK(runProgram(small).exitCode == 0);
}
