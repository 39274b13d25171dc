// Is every fault of a scene file told with its line, its column and what was expected?
#include <doctest/doctest.h>

#include <string>

#include "error_cases.h"
#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

void checkScenes(std::initializer_list<ErrorCase> cases) {
    checkErrors(cases, "room.toml", [](const std::string& text) { parseScene(text, "room.toml"); });
}

}  // namespace

TEST_CASE("scene errors carry the line and column that one counts by hand") {
    try {
        parseScene("title = \"\u00e9\"\n\n[[segment]]\na = [0, 0]\nb = [1, \"\u00e9\"]\n", "dir/x.toml");
        FAIL("accepted");
    } catch (const InputError& error) {
        CHECK(error.line == 5);
        CHECK(error.column == 9);
        CHECK(std::string(error.what()).rfind("dir/x.toml:5:9: ", 0) == 0);
    }
}

TEST_CASE("unknown keys are named, with what is allowed and what was meant") {
    checkScenes({
        {"^titel = \"x\"", {"unknown key \"titel\"", "\"title\"", "did you mean \"title\"?"}},
        {"title = \"x\"\n[[^segmnt]]\na = [0, 0]\n", {"unknown key \"segmnt\"", "did you mean \"segment\"?"}},
        {"[[circle]]\ncenter = [0, 0]\n^raduis = 1\nsegments = 8",
         {"unknown key \"raduis\" in [[circle]]", "expected one of", "did you mean \"radius\"?"}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\n^twosided = true", {"did you mean \"twoSided\"?"}},
        {"[[box]]\nmin = [0, 0]\nmax = [1, 1]\n^radius = 1",
         {"unknown key \"radius\" in [[box]]", "\"facing\""}},
        {"environment = { ^radiane = 1 }",
         {"unknown key \"radiane\" in environment", "did you mean \"radiance\"?"}},
        {"[material.white]\n^colour = 1", {"unknown key \"colour\" in [material.white]", "\"albedo\""}},
        {"[[light]]\ntype = \"point\"\nposition = [0, 0]\n^irradiance = 1", {"unknown key \"irradiance\""}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\n[segment.^more]\nx = 1", {"unknown key \"more\""}},
    });
}

TEST_CASE("wrong types say what was found and what was expected") {
    checkScenes({
        {"title = ^3", {"\"title\" is a whole number", "expected a string"}},
        {"title = ^2020-01-01", {"\"title\" is a date or time"}},
        {"environment = ^0.5", {"\"environment\" is a number", "expected a table"}},
        {"environment = { radiance = ^\"bright\" }", {"is a string", "one number or three"}},
        {"environment = { radiance = ^[1, 2] }", {"has 2 elements", "one number or three"}},
        {"environment = { radiance = [1, ^true, 3] }", {"is true or false", "expected a number"}},
        {"^[segment]\na = [0, 0]\nb = [1, 0]", {"\"segment\" is a table", "expected tables [[segment]]"}},
        {"segment = [^1]", {"\"segment\" is a whole number", "expected a table"}},
        {"light = ^3", {"expected tables [[light]]"}},
        {"material = ^3", {"\"material\" is a whole number", "expected a table"}},
        {"[material]\nwhite = ^3", {"\"white\" is a whole number", "expected a table"}},
        {"[[segment]]\na = ^0\nb = [1, 0]", {"\"a\" is a whole number", "two numbers [x, y]"}},
        {"[[segment]]\na = ^[0, 0, 0]\nb = [1, 0]", {"has 3 elements", "two numbers [x, y]"}},
        {"[[segment]]\na = [0, ^[0]]\nb = [1, 0]", {"is an array"}},
        {"[[segment]]\nname = ^7\na = [0, 0]\nb = [1, 0]",
         {"\"name\" is a whole number", "expected a string"}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\ntwoSided = ^1",
         {"\"twoSided\" is a whole number", "true or false"}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\nmaterial = ^[]", {"\"material\" is an array"}},
        {"[[polygon]]\npoints = ^3", {"\"points\" is a whole number", "[[x, y], ...]"}},
        {"[[polygon]]\npoints = [[0, 0], ^1, [1, 1]]", {"two numbers [x, y]"}},
        {"[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = ^8.0",
         {"\"segments\"", "a whole number from 3"}},
        {"[[circle]]\ncenter = [0, 0]\nradius = ^\"1\"\nsegments = 8", {"\"radius\" is a string"}},
        {"[[box]]\nmin = [0, 0]\nmax = [1, 1]\nfacing = ^1",
         {"\"facing\" is a whole number", "expected a string"}},
        {"[[light]]\ntype = ^1", {"\"type\" is a whole number"}},
    });
}

TEST_CASE("numbers that mean nothing are refused") {
    checkScenes({
        {"environment = { radiance = ^nan }", {"is nan"}},
        {"environment = { radiance = ^inf }", {"is inf"}},
        {"environment = { radiance = ^-0.1 }", {"is -0.1", "from 0"}},
        {"environment = { radiance = [0, 0, ^-1] }", {"is -1"}},
        {"[[segment]]\na = [^nan, 0]\nb = [1, 0]", {"\"a\" is nan"}},
        {"[[segment]]\na = [0, 0]\nb = [1, ^-inf]", {"\"b\" is -inf"}},
        {"[[segment]]\na = [0, 0]\nb = [^1.1e9, 0]", {"\"b\" is 1100000000", "-1e9 to 1e9"}},
        {"[[segment]]\na = [0, ^-2000000000]\nb = [1, 0]", {"\"a\" is -2000000000"}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\nemission = ^-1", {"\"emission\" is -1"}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\nemission = [1, ^nan, 1]", {"\"emission\" is nan"}},
        {"[material.m]\nalbedo = ^1.01", {"\"albedo\" is 1.01", "from 0 to 1"}},
        {"[material.m]\nalbedo = [0.5, ^-0.5, 0]", {"\"albedo\" is -0.5"}},
        {"[material.m]\nalbedo = ^nan", {"\"albedo\" is nan"}},
        {"[[light]]\ntype = \"point\"\nposition = [0, ^nan]", {"\"position\" is nan"}},
        {"[[light]]\ntype = \"point\"\nposition = [0, 0]\nintensity = ^-2", {"\"intensity\" is -2"}},
        {"[[light]]\ntype = \"directional\"\ndirection = [0, -1]\nirradiance = ^-2",
         {"\"irradiance\" is -2"}},
        {"[[light]]\ntype = \"directional\"\ndirection = ^[0, 0.0]", {"\"direction\" is [0, 0]"}},
        {"[[light]]\ntype = \"directional\"\ndirection = [^inf, 0.0]", {"\"direction\" is inf"}},
        {"[[circle]]\ncenter = [0, 0]\nradius = ^0\nsegments = 8", {"\"radius\" is 0", "above 0"}},
        {"[[circle]]\ncenter = [0, 0]\nradius = ^-1\nsegments = 8", {"\"radius\" is -1"}},
        {"[[circle]]\ncenter = [^1e10, 0]\nradius = 1\nsegments = 8", {"\"center\""}},
        {"[[arc]]\ncenter = [0, 0]\nradius = ^0.0\nfrom = 0\nto = 90\nsegments = 8", {"\"radius\" is 0"}},
        {"[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = ^nan\nto = 90\nsegments = 8", {"\"from\" is nan"}},
        {"[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = 0\nto = ^1e5\nsegments = 8", {"\"to\""}},
    });
}

TEST_CASE("shapes without a front are refused") {
    checkScenes({
        {"[[segment]]\na = [1, 2]\nb = ^[1, 2]", {"zero length"}},
        {"[[segment]]\na = [1e8, 0]\nb = ^[100000000.00000001, 0]", {"zero length"}},
        {"[[segment]]\na = [1, 0]\nb = ^[1.0000000000000002, 0]", {"zero length"}},
        {"[[segment]]\na = [0, 0]\nb = ^[1e-200, 0]", {"zero length"}},
        {"[[polyline]]\npoints = [[0, 0], [1, 0], ^[1, 0], [2, 0]]", {"zero length"}},
        {"[[polygon]]\npoints = [[0, 0], ^[0, 0], [1, 1]]", {"zero length"}},
        {"[[polygon]]\npoints = [[0, 0], [1, 0], [1, 1], ^[0, 0]]", {"zero length", "closes by itself"}},
        {"[[polyline]]\npoints = ^[[0, 0]]", {"has 1 point,", "at least 2"}},
        {"[[polygon]]\npoints = ^[[0, 0], [1, 0]]", {"has 2 points", "at least 3"}},
        {"[[polygon]]\npoints = ^[]", {"has 0 points"}},
        {"[[box]]\nmin = [0, 0]\nmax = ^[0, 1]", {"\"max\" is [0, 1]", "more than \"min\""}},
        {"[[box]]\nmin = [0, 2]\nmax = ^[1, 1]", {"\"max\" is [1, 1]"}},
        {"[[box]]\nmin = [1, 0]\nmax = ^[1.0000000000000002, 1]", {"zero length"}},
        {"[[circle]]\ncenter = [1e9, 0]\nradius = ^1e-9\nsegments = 8",
         {"\"radius\" is too small", "zero length"}},
        {"[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = 30\nto = ^30\nsegments = 8",
         {"\"to\" equals \"from\""}},
        {"[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = 0\nto = ^361\nsegments = 8", {"361", "at most 360"}},
        {"[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = 0\nto = 270\nsegments = ^1", {"270", "at most 180"}},
    });
}

TEST_CASE("absurd counts are refused") {
    checkScenes({
        {"[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = ^2",
         {"\"segments\" is 2", "from 3 to 1000000"}},
        {"[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = ^-8", {"\"segments\" is -8"}},
        {"[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = ^1000000000", {"\"segments\" is 1000000000"}},
        {"[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = ^4294967299", {"\"segments\" is 4294967299"}},
        {"[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = 0\nto = 9\nsegments = ^0",
         {"\"segments\" is 0", "from 1"}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\n^[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = 1000000",
         {"1000001 segments", "at most 1000000"}},
    });
}

TEST_CASE("names are checked") {
    checkScenes({
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\nmaterial = ^\"whte\"\n[material.white]\nalbedo = 1",
         {"no material \"whte\"", "\"white\" or \"default\"", "did you mean \"white\"?"}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\nmaterial = ^\"white\"",
         {"no material \"white\"", "expected \"default\""}},
        {"[material.m]\ntype = ^\"difuse\"", {"\"type\" is \"difuse\"", "did you mean \"diffuse\"?"}},
        {"[[light]]\ntype = ^\"spot\"", {"\"type\" is \"spot\"", "\"point\" or \"directional\""}},
        {"[[box]]\nmin = [0, 0]\nmax = [1, 1]\nfacing = ^\"inn\"",
         {"\"out\" or \"in\"", "did you mean \"in\"?"}},
        {"[[segment]]\nname = \"w\"\na = [0, 0]\nb = [1, 0]\n[[box]]\nname = ^\"w\"\nmin = [0, 0]\nmax = [1, "
         "1]",
         {"\"w\" is taken", "line 2"}},
        {"[[box]]\nname = \"w\"\nmin = [0, 0]\nmax = [1, 1]\n[[segment]]\nname = ^\"w.3\"\na = [0, 0]\nb = "
         "[1, 0]",
         {"\"w.3\" is taken by an edge", "line 2"}},
        {"[[segment]]\nname = ^\"\"\na = [0, 0]\nb = [1, 0]", {"the name is empty"}},
        {"[[segment]]\nname = ^\"a:b\"\na = [0, 0]\nb = [1, 0]", {"holds a ':'"}},
        {"[[segment]]\nname = ^\"a\\nb\"\na = [0, 0]\nb = [1, 0]", {"control character"}},
        {"[[segment]]\nname = ^\"a\\u0085b\"\na = [0, 0]\nb = [1, 0]", {"control character"}},
        {"[material.^\"a:b\"]\nalbedo = 1", {"holds a ':'"}},
        {"[material.^\"\"]\nalbedo = 1", {"the name is empty"}},
        {"title = ^\"a\\tb\"", {"control character"}},
    });
    const std::string longName(201, 'x');
    const std::string text = "[[segment]]\nname = ^\"" + longName + "\"\na = [0, 0]\nb = [1, 0]";
    checkScenes({{text, {"has 201 characters", "at most 200"}}});
    const std::string title = "title = ^\"" + longName + "\"";
    checkScenes({{title, {"has 201 characters", "at most 200"}}});
}

TEST_CASE("names of 200 characters and unused edge numbers are fine") {
    std::string longName;
    for (int i = 0; i < 200; ++i) longName += "\u03c1";
    CHECK_NOTHROW(parseScene("[[segment]]\nname = \"" + longName + "\"\na = [0, 0]\nb = [1, 0]", "x"));
    CHECK_NOTHROW(
        parseScene("[[box]]\nname = \"w\"\nmin = [0, 0]\nmax = [1, 1]\n"
                   "[[segment]]\nname = \"w.4\"\na = [0, 0]\nb = [1, 0]\n"
                   "[[segment]]\nname = \"w.04\"\na = [0, 0]\nb = [1, 0]",
                   "x"));
}

TEST_CASE("missing keys are told at their table") {
    checkScenes({
        {"^[[segment]]\na = [0, 0]", {"[[segment]] has no \"b\""}},
        {"title = \"x\"\n  ^[[polyline]]\nname = \"p\"", {"[[polyline]] has no \"points\""}},
        {"^[[polygon]]\n", {"has no \"points\""}},
        {"^[[box]]\nmin = [0, 0]", {"has no \"max\""}},
        {"^[[circle]]\ncenter = [0, 0]\nsegments = 8", {"has no \"radius\""}},
        {"^[[arc]]\ncenter = [0, 0]\nradius = 1\nsegments = 8\nto = 1", {"has no \"from\""}},
        {"^[[light]]\nposition = [0, 0]", {"has no \"type\"", "\"point\" or \"directional\""}},
        {"^[[light]]\ntype = \"point\"", {"has no \"position\""}},
        {"^[[light]]\ntype = \"directional\"", {"has no \"direction\""}},
        {"[[segment]]\na = [0, 0]\nb = [1, 0]\n^[[segment]]\nb = [1, 0]", {"has no \"a\""}},
        {"segment = [{ a = [0, 0], b = [1, 0] }, ^{ a = [0, 0] }]", {"has no \"b\""}},
    });
}

TEST_CASE("an eye is checked") {
    const std::string eye = "[eye]\nposition = [0, 0]\n";
    const auto check = [](const std::string& text, std::initializer_list<std::string_view> said) {
        checkScenes({{text, said}});
    };
    check("^[eye]\ndirection = [1, 0]", {"[eye] has no \"position\""});
    check("^" + eye, {"[eye] has no \"direction\""});
    check(eye + "direction = ^[0, 0.0]", {"\"direction\" is [0, 0]", "the direction that the eye looks in"});
    check(eye + "direction = [^nan, 0]", {"\"direction\" is nan"});
    check(eye + "direction = [1, 0]\nfov = ^0", {"\"fov\" is 0", "above 0, at most 179"});
    check(eye + "direction = [1, 0]\nfov = ^-90", {"\"fov\" is -90"});
    check(eye + "direction = [1, 0]\nfov = ^179.01", {"\"fov\" is 179.01", "at most 179"});
    check(eye + "direction = [1, 0]\n^fow = 90", {"unknown key \"fow\" in [eye]", "did you mean \"fov\"?"});
    check("^[[eye]]\nposition = [0, 0]\ndirection = [1, 0]", {"\"eye\" is an array", "a scene has one eye"});
    check(eye + "direction = [1, 0]\n^[eye]\nposition = [1, 1]", {"not valid TOML"});
    check("eye = ^3", {"\"eye\" is a whole number", "expected a table"});
}

TEST_CASE("text that is no TOML is refused") {
    const std::string deepKey = "a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.^q = 1";
    checkScenes({
        {"title = \"\u00e9^\xff\"", {"byte 0xFF is not valid UTF-8"}},
        {"title = \"a\"\n# \xce\xb1 ^\xc0\x80", {"byte 0xC0"}},
        {"title = \"a\"\n^\xed\xa0\x80", {"byte 0xED"}},
        {"title = \"a\" # ^\xf4\x90\x80\x80", {"byte 0xF4"}},
        {"title = \"a\" # ^\xe2\x82", {"byte 0xE2"}},
        {"title = ^", {"not valid TOML"}},
        {"title = \"x\"\ntitle = ^\"y\"", {"not valid TOML", "title"}},
        {"[[segment]^\na = 1", {"not valid TOML"}},
        {"title = ^maybe", {"not valid TOML"}},
        {"title = ^\u03b8", {"\"\u03b8\" stands outside of quotes"}},
        {"title = \"^\U00100001\"", {"private character"}},
        {"title = \"x\"\n[^=]", {"not valid TOML"}},
        {deepKey, {"too many parts", "at most 16"}},
    });
}

TEST_CASE("deep nesting ends in a message, not in a crash") {
    const auto refused = [](const std::string& text) {
        try {
            parseScene(text, "deep.toml");
        } catch (const InputError& error) {
            return error.line == 1 && error.column > 1;
        }
        return false;
    };
    const auto nested = [&](std::string text, std::string_view part, int count, std::string_view end) {
        for (int i = 0; i < count; ++i) text += part;
        text += end;
        return refused(text);
    };
    CHECK(nested("a = ", "[", 1'000'000, ""));
    CHECK(nested("a = ", "{ a = ", 500'000, ""));
    CHECK(nested("[", "a.", 1'000'000, "a]"));
    CHECK(nested("[", "a . ", 500'000, "a]"));
    CHECK(nested("[", "\"#\".", 500'000, "a]"));
    CHECK(nested("a = {", "a.", 1'000'000, "a = 1}"));
}

TEST_CASE("dots in strings, comments and numbers are no nesting") {
    CHECK_NOTHROW(
        parseScene("title = \"....................\" # ....................\n"
                   "[[polyline]]\npoints = [[0.0, 0.5], [1.5, 2.5], [3.5, 4.5], [5.5, 6.5], [7.5, 8.5]]\n"
                   "name = '''...'................'''\nmaterial = \"\"\"default\"\"\"\n",
                   "x"));
}
