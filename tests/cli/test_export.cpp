// Does `halfdisk export` write what its help lists, and are states read from files and standard input?
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "refusals.h"
#include "run_program.h"

using namespace halfdisk_test;

namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::size_t filesIn(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("export: every file that is printed is there, and no other") {
    const TemporaryFolder folder;
    const std::filesystem::path made = folder / "a" / "b";
    const Outcome outcome =
        runProgram({"export", "gather:5", "-o", made.string(), "--size", "640x480", "--scale", "0.75"});
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    CHECK(outcome.err == "");
    const std::vector<std::string> files = linesOf(outcome.out);
    CHECK(files.size() == filesIn(made));
    for (const std::string& file : files) CHECK_MESSAGE(!readFile(file).empty(), file);
    for (const char* name : {"screen.png", "canvas.svg", "integrand.svg", "integrand.csv", "tree.json",
                             "state.txt", "state.halfdisk"})
        CHECK_MESSAGE(std::find(files.begin(), files.end(), (made / name).string()) != files.end(), name);
    CHECK(readFile(made / "screen.png").substr(1, 3) == "PNG");
    // The width and height of a PNG stand in its first chunk.
    CHECK(readFile(made / "screen.png").substr(16, 8) == std::string("\0\0\x02\x80\0\0\x01\xe0", 8));
    const auto tree = nlohmann::json::parse(readFile(made / "tree.json"));
    CHECK(tree["lesson"] == "gather");
    CHECK(tree["events"].size() > 0);
}

TEST_CASE("export: a state brings the same files back, from an argument, a file and standard input") {
    const TemporaryFolder folder;
    const auto at = [&](const char* name) { return (folder / name).string(); };
    REQUIRE(runProgram({"export", "trade:3", "-o", at("first")}).exitCode == 0);
    const std::string state = readFile(folder / "first" / "state.halfdisk");
    const std::string file = (folder / "first" / "state.halfdisk").string();
    REQUIRE(runProgram({"export", "--state", state, "-o", at("text")}).exitCode == 0);
    REQUIRE(runProgram({"export", "--state", "@" + file, "-o", at("file")}).exitCode == 0);
    REQUIRE(runProgramFrom(file, {"export", "--state", "-", "-o", at("input")}).exitCode == 0);
    for (const char* other : {"text", "file", "input"})
        for (const auto& entry : std::filesystem::directory_iterator(folder / "first"))
            CHECK_MESSAGE(readFile(entry.path()) == readFile(folder / other / entry.path().filename()),
                          entry.path().string());
    REQUIRE(runProgram({"screenshot", "--state", "@" + file, "-o", at("s.png")}).exitCode == 0);
    CHECK(readFile(folder / "s.png") == readFile(folder / "first" / "screen.png"));
}

TEST_CASE("export: what cannot be done is refused in one line") {
    const TemporaryFolder folder;
    const std::string there = (folder / "there").string();
    std::ofstream(there) << "a file";
    checkRefused({"export", "gather", "-o", there}, "--output: '");
    checkRefused({"export", "gather", "-o", there + "/below"}, "no folder that can be made");
    checkRefused({"export", "gather", "-o", "/proc/halfdisk"}, "no folder that can be made");
    checkRefused({"export", "gather"}, "--output is required");
    const std::string output = (folder / "new").string();
    checkRefused({"export", "-o", output},
                 "nothing to draw, expected LESSON[:STEP], --scene FILE or --state TEXT");
    checkRefused({"export", "gatherr", "-o", output}, "there is no lesson \"gatherr\"");
    checkRefused({"export", "gather:99", "-o", output}, "99");
    checkRefused({"export", "gather", "--state", "x", "-o", output}, "expected no other");
    checkRefused({"export", "--state", "halfdisk.broken", "-o", output}, "the shared text is damaged");
    checkRefused({"export", "--state", "@" + there, "-o", output}, "the shared text is damaged");
    checkRefused({"export", "--state", "@" + output, "-o", output}, "cannot be opened");
    checkRefused({"export", "--state", "@" + folder.path.string(), "-o", output}, "cannot be read");
    checkRefused({"--state", "@" + output}, "cannot be opened");
    checkRefused({"screenshot", "-o", output}, "nothing to draw");
    checkRefused({"export", "gather", "-o", output, "--size", "10x10"}, "--size");
    checkRefused({"export", "gather", "-o", output, "--scale", "9"}, "--scale");
    CHECK_FALSE(std::filesystem::exists(output));
    if (geteuid() == 0) return;  // who may write everywhere
    const auto locked = folder / "locked";
    std::filesystem::create_directory(locked);
    std::filesystem::permissions(locked,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    checkRefused({"export", "gather", "-o", locked.string()}, "Permission denied");
    checkRefused({"export", "gather", "-o", (locked / "below").string()}, "Permission denied");
}

TEST_CASE("export: a scene by itself") {
    const TemporaryFolder folder;
    const Outcome outcome =
        runProgram({"export", "--scene", shippedScene("small_room.toml"), "-o", folder.path.string()});
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    CHECK(nlohmann::json::parse(readFile(folder / "tree.json"))["lesson"].is_null());
    CHECK(readFile(folder / "histogram.csv").find("from (W/m)") == 0);
}
