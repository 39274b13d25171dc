// Does the teacher's walk of the README work, on the command line? (What the window does in it:
// test_editing.cpp.)
#include <doctest/doctest.h>

#include <fstream>

#include "run_program.h"

using namespace halfdisk_test;

TEST_CASE(
    "classroom: a lesson of one's own over a changed scene is verified, drawn and refused as it should be") {
    const TemporaryFolder folder;
    const std::string scene = readFile(shippedScene("glass_disk.toml"));
    const std::size_t ior = scene.find("ior = 1.5");
    REQUIRE(ior != std::string::npos);
    std::ofstream(folder / "my_glass_disk.toml") << std::string(scene).replace(ior, 9, "ior = 1.3");
    const std::string head =
        "title = 'My glass'\nsection = 'Caustics'\nscene = 'my_glass_disk.toml'\n"
        "[defaults]\ndepth = 0\nat = 'floor:0.5'\n"
        "[[step]]\ntitle = 'Dark'\nprose = 'castRay finds nothing.'\nshow = ['halfdisk', 'rays']\n"
        "[[step.claim]]\nsays = 'Nothing'\nmeasure = 'irradiance'\nequals = 0\n"
        "[[step]]\ntitle = 'Light'\nprose = 'Photons find it.'\nshow = ['profile']\nunlock = 'params'\n"
        "[step.set]\nestimator = 'photon-map'\n"
        "[[step.claim]]\nsays = 'The light gathers'\nmeasure = 'irradiance'\n"
        "with = { estimator = 'photon-map', samples = 10 }\n";
    const std::string lesson = (folder / "01-my-glass.toml").string();
    const auto write = [&](const char* relation) { std::ofstream(lesson) << head << relation; };

    write("atLeast = 1.5\n");
    const Outcome held = runProgram({"verify", lesson});
    CHECK_MESSAGE(held.exitCode == 0, held.err);
    CHECK(held.out.find("2 claims, 2 of them true") != std::string::npos);
    const std::string slide = (folder / "slide.png").string();
    const Outcome drawn = runProgram(
        {"screenshot", "my-glass:2", "--lessons", folder.path.string(), "-o", slide, "--scale", "2"});
    CHECK_MESSAGE(drawn.exitCode == 0, drawn.err);
    CHECK(readFile(slide).substr(1, 3) == "PNG");

    write("atLeast = 1000\n");
    const Outcome failed = runProgram({"verify", lesson});
    CHECK(failed.exitCode == 1);
    CHECK(failed.err.find("not true: \"The light gathers\": irradiance is ") != std::string::npos);
}

TEST_CASE("classroom: what a class may not touch is checked before the window opens") {
    for (const auto& [arguments, said] :
         {std::pair<std::vector<std::string>, std::string>{{"caustic", "--lock", "sample=4"}, "did you mean"},
          {{"caustic", "--lock", "samples=0"}, "--lock: '0' is not a whole number from 1 to 4096"},
          {{"caustic", "--hide", "histogramm"}, "did you mean \"histogram\""},
          {{"lessons", "--kiosk"}, "--kiosk"}}) {
        const Outcome outcome = runProgram(arguments);
        CHECK(outcome.exitCode == 2);
        CHECK_MESSAGE(outcome.err.find(said) != std::string::npos, outcome.err);
    }
}
