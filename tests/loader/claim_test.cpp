// Is what a step claims read, and every fault of a claim told?
#include <doctest/doctest.h>

#include "error_cases.h"
#include "lessons/lesson_file.h"
#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

SceneDescription room(const std::filesystem::path&) {
    return parseScene("[[segment]]\nname = \"floor\"\na = [0, 0]\nb = [1, 0]", "room");
}

const std::string kHead =
    "title = 'T'\nsection = 'S'\nscene = 'room'\n[[step]]\ntitle = 'A'\nprose = 'B'\n"
    "[step.set]\nsamples = 4\nat = 'floor:0.25'\n";
const std::string kStep = kHead + "[[step.claim]]\n";

Claim claimOf(const std::string& keys) {
    return parseLesson(kStep + keys, "dir/01-x.toml", room).steps.at(0).claims.at(0);
}

void checkText(const std::string& text, std::initializer_list<std::string_view> said) {
    checkErrors({{text, said}}, "dir/01-x.toml",
                [](const std::string& lesson) { parseLesson(lesson, "dir/01-x.toml", room); });
}

void check(const std::string& keys, std::initializer_list<std::string_view> said) {
    checkText(kStep + keys, said);
}

const std::string kSays = "says = 'W'\nmeasure = 'rays'\n";

}  // namespace

TEST_CASE("a claim measures what its step sets, but for what it sets itself") {
    const Claim claim = claimOf(
        "says = 'Noise'\nmeasure = 'variance'\nwith = { samples = 8, specular = 2, repeats = 50, estimator = "
        "'path' }\n"
        "over = { sampler = 'cosine', params = { roulette = 9, emitters = 'both' } }\natLeast = 10\n");
    CHECK(claim.says == "Noise");
    CHECK(claim.quantity == Quantity::variance);
    CHECK(claim.relation == Relation::atLeast);
    CHECK(claim.number == 10.0);
    CHECK(claim.where == TextPosition{15, 11});
    CHECK(claim.of.settings.samples == 8);
    CHECK(claim.of.at == WallPoint{0, 0.25});
    CHECK(claim.of.settings.maxSpecular == 2);
    CHECK(claim.of.repeats == 50);
    CHECK(claim.of.maker.estimator == "path");
    REQUIRE(claim.over.has_value());
    CHECK(claim.over->settings.samples == 8);
    CHECK(claim.over->settings.sampler == Sampler::cosine);
    CHECK(claim.over->maker.estimator == "path");
    CHECK(claim.over->maker.params == ParamValues{2.0, 0.0, 0.0, 9.0});

    const Claim plain = claimOf("says = 'R'\nmeasure = 'rays'\nequals = 5\ntolerance = 0.5");
    CHECK(plain.of.settings.samples == 4);
    CHECK(plain.relation == Relation::equals);
    CHECK(plain.tolerance == 0.5);
    CHECK_FALSE(plain.over.has_value());
}

TEST_CASE("claims are checked") {
    checkText(kHead + "^[[step.claim]]\nequals = 1", {"[[step.claim]] has no \"says\""});
    check(kSays + "equals = 1\n^atmost = 2", {"unknown key \"atmost\"", "did you mean \"atMost\"?"});
    check(kSays + "equals = ^1\natMost = 2", {"two numbers", "\"atLeast\", \"atMost\", \"equals\""});
    check(kSays + "equals = ^'1'", {"\"equals\" is a string", "expected a finite number"});
    check(kSays + "equals = ^nan", {"\"equals\" is nan"});
    check(kSays + "atMost = 1\ntolerance = ^1", {"only \"equals\" has a \"tolerance\""});
    check(kSays + "equals = 1\ntolerance = ^-1", {"\"tolerance\" is -1"});
    check("says = 'W'\nequals = 1\nmeasure = ^'din'", {"\"measure\" is \"din\"", "variance"});
    check(kSays + "equals = 1\nwith = { repeats = ^0 }", {"\"repeats\" is 0", "from 1 to 1000000"});
    check(kSays + "equals = 1\nwith = { at = ^'wall:0' }", {"\"at\": there is no wall \"wall\""});
    check(kSays + "equals = 1\nwith = { ^event = 3 }", {"unknown key \"event\""});
    check(kSays + "equals = 1\nover = ^3", {"\"over\" is a whole number", "expected a table"});
    check(kSays + "equals = 1\nover = { estimator = 'path', params = { a = ^1 } }",
          {"parameter of path \"a\" is unknown", "roulette"});
    check(kSays + "equals = 1\nover = { estimator = 'path', params = { roulette = ^true } }",
          {"\"roulette\" is true or false", "expected a whole number"});
    check(kSays + "equals = 1\nwith = { estimator = ^'pth' }", {"estimator \"pth\" is unknown", "path"});
    check(kSays + "equals = 1\nwith = { params = ^{ samples = 3 } }",
          {"\"params\" are not for cast-ray at P", "\"sampler\""});
    check(kSays + "equals = 1\nwith = { picture = ^'eye' }",
          {"\"picture\" means nothing where \"rays\" is measured", "\"noise\", \"pictureError\""});
    check("says = 'W'\nmeasure = 'exact'\nequals = 1\nover = { repeats = ^3 }",
          {"\"repeats\" means nothing where \"exact\"", "\"irradiance\""});
    check("says = 'W'\nmeasure = 'raysTo'\nequals = 1\nwith = { tradeCost = ^'rays' }",
          {"\"tradeCost\" means nothing", "expected \"wishedError\""});
}
