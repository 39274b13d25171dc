// Is every fault of a lesson file told with its line, its column and what was expected?
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "error_cases.h"
#include "lessons/lesson_file.h"
#include "lessons/scene_file.h"
#include "temp_folder.h"

using namespace halfdisk;

namespace {

/// Stands for the file system: "room" has walls, "void" has none, "bad" has a fault in line 1, others do not
/// exist.
SceneDescription sceneNamed(const std::filesystem::path& path) {
    if (path.filename() == "room")
        return parseScene("[[segment]]\nname = \"floor\"\na = [0, 0]\nb = [1, 0]", "room");
    if (path.filename() == "void") return {};
    if (path.filename() == "bad") return parseScene("titel = 1", path.string());
    throw InputError(path.string(), "there is no such file");
}

const std::string kHead = "title = 'T'\nsection = 'S'\nscene = 'room'\n";
const std::string kStep = kHead + "[[step]]\ntitle = 'A'\nprose = 'B'\n";
const std::string kTerm = kHead + "[[term]]\nname = 'light'\nmeaning = 'M'\n[[step]]\ntitle = 'A'\n";

void check(const std::string& text, std::initializer_list<std::string_view> said) {
    checkErrors({{text, said}}, "dir/01-x.toml",
                [](const std::string& lesson) { parseLesson(lesson, "dir/01-x.toml", sceneNamed); });
}

}  // namespace

TEST_CASE("the head of a lesson is checked") {
    check("^", {"a lesson file has no \"title\""});
    check("^section = 'S'\nscene = 'room'\n[[step]]\ntitle='A'\nprose='B'", {"has no \"title\""});
    check("^title = 'T'\nscene = 'room'\n[[step]]\ntitle='A'\nprose='B'", {"has no \"section\""});
    check("^title = 'T'\nsection = 'S'\n[[step]]\ntitle='A'\nprose='B'", {"has no \"scene\""});
    check("^" + kHead, {"has no \"step\""});
    check(kHead + "step = ^[]", {"at least one [[step]]"});
    check(kHead + "^[step]\ntitle = 'A'", {"\"step\" is a table", "expected tables [[step]]"});
    check(kHead + "^steps = 3\n", {"unknown key \"steps\"", "did you mean \"step\"?"});
    check("title = ^3\nsection = 'S'\nscene = 'room'\nstep = []", {"\"title\" is a whole number"});
    check("title = ^' '\nsection = 'S'\nscene = 'room'\nstep = []", {"\"title\" is empty"});
    check("title = 'T\xce\xb1^\xff'", {"not valid UTF-8"});
    check("title = 'T'\nsection = ^", {"not valid TOML"});
}

TEST_CASE("the scene of a lesson is checked") {
    const std::string rest = "\n[[step]]\ntitle = 'A'\nprose = 'B'\n";
    check("title = 'T'\nsection = 'S'\nscene = ^'none'" + rest, {"dir/none: there is no such file"});
    check("title = 'T'\nsection = 'S'\nscene = ^'void'" + rest, {"no walls"});
    check("title = 'T'\nsection = 'S'\nscene = ^''" + rest, {"\"scene\" is empty"});
    check("title = 'T'\nsection = 'S'\nscene = ^['room']" + rest, {"\"scene\" is an array"});
    // A fault within the scene file is told with that file's name and place.
    CHECK_THROWS_WITH_AS(
        parseLesson("title = 'T'\nsection = 'S'\nscene = 'bad'" + rest, "dir/01-x.toml", sceneNamed),
        doctest::Contains("dir/bad:1:1: unknown key \"titel\""), InputError);
}

TEST_CASE("terms are checked") {
    check(kHead + "^[[term]]\nname = 'a'\n" + "[[step]]\ntitle='A'\nprose='B'",
          {"[[term]] has no \"meaning\""});
    check(kHead + "[[term]]\nname = ^'a[b'\nmeaning = 'M'\n[[step]]\ntitle='A'\nprose='B'",
          {"without markup"});
    check(kHead + "[[term]]\nname = ^''\nmeaning = 'M'\n[[step]]\ntitle='A'\nprose='B'", {"name is empty"});
    check(kHead + "[[term]]\nname = 'a'\nmeaning = ^''\n[[step]]\ntitle='A'\nprose='B'",
          {"\"meaning\" is empty"});
    check(
        kHead +
            "[[term]]\nname = 'a'\nmeaning = 'M'\n[[term]]\nname = ^'A'\nmeaning = 'M'\n[[step]]\ntitle='A'\n"
            "prose='B'",
        {"\"A\" is explained twice"});
}

TEST_CASE("steps are checked") {
    check(kHead + "^[[step]]\ntitle = 'A'\n", {"[[step]] has no \"prose\""});
    check(kStep + "^[[step]]\nprose = 'A'\n", {"[[step]] has no \"title\""});
    check(kStep + "^unlok = 'samples'", {"unknown key \"unlok\" in [[step]]", "did you mean \"unlock\"?"});
    check(kStep + "unlock = ^'sample'", {"\"unlock\" is \"sample\"", "did you mean \"samples\"?"});
    check(kStep + "unlock = ^['samples', 'depth']", {"at most one"});
    check(kStep + "show = ^'rays'", {"\"show\" is a string", "expected an array of views"});
    check(kStep + "show = ['rays', ^'ray']",
          {"\"show\" is \"ray\"", "\"halfdisk\"", "did you mean \"rays\"?"});
    check(kStep + "show = ['rays', ^'rays']", {"twice"});
    check(kStep + "listing = [1, ^35]", {"\"listing\" is 35", "from 1 to 34"});
    check(kStep + "listing = [^0]", {"\"listing\" is 0"});
    check(kStep + "listing = [3, ^3]", {"line 3 twice"});
    check(kStep + "listing = ^3", {"\"listing\" is a whole number"});
    check(kStep + "listing = [^1.5]", {"a whole number from 1 to 34"});
    check(kStep + "^[step.question]\nask = 'Q'", {"[step.question] has no \"answer\""});
    check(kStep + "[step.question]\nask = ^''\nanswer = 'A'", {"\"ask\" is empty"});
    check(kStep + "question = ^'Q'", {"\"question\" is a string", "expected a table"});
}

TEST_CASE("a lesson has at most 200 steps") {
    std::string text = kHead;
    for (int i = 0; i < 200; ++i) text += "[[step]]\ntitle = 'A'\nprose = 'B'\n";
    CHECK_NOTHROW(parseLesson(text, "dir/01-x.toml", sceneNamed));
    check(text + "^[[step]]\ntitle = 'A'\nprose = 'B'\n", {"201 tables [[step]]", "at most 200"});
}

TEST_CASE("values are checked, in a step as in the defaults") {
    for (const std::string& head : {kStep + "[step.set]\n", kHead + "[defaults]\n"}) {
        const std::string tail =
            head.find("[defaults]") == std::string::npos ? "" : "\n[[step]]\ntitle='A'\nprose='B'";
        check(head + "samples = ^0" + tail, {"\"samples\" is 0", "from 1 to 4096"});
        check(head + "samples = ^4097" + tail, {"\"samples\" is 4097"});
        check(head + "samples = ^16.0" + tail, {"expected a whole number"});
        check(head + "depth = ^9" + tail, {"\"depth\" is 9", "from 0 to 8"});
        check(head + "depth = ^-1" + tail, {"\"depth\" is -1"});
        check(head + "seed = ^-1" + tail, {"\"seed\" is -1"});
        check(head + "sampler = ^'unifrom'" + tail, {"\"cosine\"", "did you mean \"uniform\"?"});
        check(head + "emitters = ^'none'" + tail, {"\"sample\", \"hit\" or \"both\""});
        check(head + "asPrinted = ^1" + tail, {"\"asPrinted\" is a whole number", "true, false or an array"});
        check(head + "asPrinted = ['frame', ^'fram']" + tail, {"did you mean \"frame\"?"});
        check(head + "asPrinted = ['pdf', ^'pdf']" + tail, {"lists \"pdf\" twice"});
        check(head + "event = ^-1" + tail, {"\"event\" is -1"});
        check(head + "event = ^1.0" + tail, {"\"event\" is 1"});
        check(head + "at = ^'flor:0.5'" + tail, {"no wall \"flor\"", "expected \"floor\"", "did you mean"});
        check(head + "at = ^'floor'" + tail, {"NAME:T"});
        check(head + "at = ^'floor:2'" + tail, {"T from 0 to 1"});
        check(head + "at = ^[0, 1]" + tail, {"\"at\" is an array"});
        check(head + "^smaples = 3" + tail, {"unknown key \"smaples\"", "did you mean \"samples\"?"});
    }
}

TEST_CASE("a pixel is one of the strip that a scene's eye sees and the step shows") {
    check(kStep + "[step.set]\npixel = ^3", {"\"pixel\"", "a scene with an [eye]"});
    const auto withEye = [](const std::filesystem::path& file) {
        SceneDescription scene = sceneNamed(file);
        scene.eye = EyeDescription{{0.0, 1.0}, {1.0, 0.0}, 60.0};
        return scene;
    };
    const std::string seen = kHead + "[[step]]\ntitle = 'A'\nprose = 'B'\nshow = ['eye']\n[step.set]\n";
    const auto refusal = [&](const std::string& text) -> std::string {
        try {
            parseLesson(text, "dir/01-x.toml", withEye);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    };
    CHECK(refusal(seen + "pixel = 255").empty());
    CHECK(parseLesson(seen + "pixel = 255", "dir/01-x.toml", withEye).steps.front().values.pixel == 255u);
    CHECK(refusal(seen + "pixel = 256").find("\"pixel\" is 256, expected a whole number from 0 to 255") !=
          std::string::npos);
    // Where the pixel stands; of one from [defaults], the step's "show".
    const std::string unseen = kHead + "[[step]]\ntitle = 'A'\nprose = 'B'\nshow = ['rays']\n[step.set]\n";
    const auto lines = std::count(unseen.begin(), unseen.end(), '\n');
    CHECK(refusal(unseen + "seed = 1\npixel = 3").find("01-x.toml:" + std::to_string(lines + 2) + ":") !=
          std::string::npos);
    CHECK(refusal(seen + "pixel = -1").find("\"pixel\" is -1") != std::string::npos);
    CHECK(refusal(seen + "pixel = 'left'").find("\"pixel\" is a string") != std::string::npos);
    const std::string hidden = refusal(kStep + "[step.set]\npixel = 3");
    CHECK(hidden.find("expected \"eye\" in \"show\"") != std::string::npos);
    CHECK(hidden.find("dir/01-x.toml:") == 0);
}

TEST_CASE("faults of the markup are found in the middle of the prose") {
    check(kTerm + "prose = \"\"\"\nFirst line.\nSome \u222b ^[lihgt] here.\n\"\"\"",
          {"\"prose\": [lihgt]", "did you mean \"light\"?"});
    check(kTerm + "prose = '''\nA [light] is **on**,\n\nand ^*this never ends\n'''", {"never closed"});
    check(kTerm + "prose = '^[\\[ ]'", {"\"prose\": "});
    check(kTerm + "prose = ^''", {"\"prose\" is empty"});
    check(kTerm + "prose = 'x'\n[step.question]\nask = 'a'\nanswer = 'some ^`code'",
          {"\"answer\": ` is never closed"});
    check(kTerm + "prose = ^\"a\\u001bb\"", {"control character"});
    // Written with TOML's own escapes, the fault is not found letter by letter: then the text's start must
    // do.
    check(kTerm + "prose = ^\"a \\u005Bnone]\"", {"names no term"});
    check(kTerm + "prose = ^'" + std::string(20'001, 'x') + "'", {"20001 characters"});
}

TEST_CASE("a file without a number cannot be a lesson") {
    CHECK_THROWS_WITH_AS(parseLesson(kStep, "dir/x.toml", sceneNamed), doctest::Contains("dir/x.toml: "),
                         InputError);
    CHECK_NOTHROW(parseLesson(kStep, "dir/01-x.toml", sceneNamed));
}
