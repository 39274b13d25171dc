// Is what makes a step's pictures, and its goal, read, and every fault of them told?
#include <doctest/doctest.h>

#include "error_cases.h"
#include "lessons/lesson_file.h"
#include "lessons/maker_reader.h"
#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

SceneDescription room(const std::filesystem::path&) {
    return parseScene("[[segment]]\nname = \"floor\"\na = [0, 0]\nb = [1, 0]", "room");
}

const std::string kHead = "title = 'T'\nsection = 'S'\nscene = 'room'\n";
const std::string kStep = "[[step]]\ntitle = 'A'\nprose = 'B'\n";
const std::string kSet = kHead + kStep + "[step.set]\n", kGoal = kHead + kStep + "[step.goal]\n";

Step stepOf(const std::string& text) {
    return parseLesson(text, "dir/01-x.toml", room).steps.at(0);
}

void check(const std::string& text, std::initializer_list<std::string_view> said) {
    checkErrors({{text, said}}, "dir/01-x.toml",
                [](const std::string& lesson) { parseLesson(lesson, "dir/01-x.toml", room); });
}

double valueOf(const Maker& maker, std::string_view name) {
    const EstimatorInfo& info = *findEstimator(maker.estimator);
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (info.params[i].name == name) return maker.params.at(i);
    return -12345.0;
}

}  // namespace

TEST_CASE("a goal may ask for a line, any of several, and a step for another run") {
    const Goal goal = *stepOf(kHead + kStep +
                              "show = ['code']\n[step.goal]\nsays = 'Go'\nreach = 'line'\nlines = [27, 30]\n")
                           .goal;
    CHECK(goal.quantity == GoalQuantity::line);
    CHECK(goal.lines == std::vector{27, 30});
    CHECK(stepOf(kSet + "run = 'photon-map'\n").values.run == Run::photonMap);
    CHECK(stepOf(kSet + "seed = 2\n").values.run == Run::castRay);
    check(kSet + "run = ^'radiosity'\n", {"\"bidirectional\""});
}

TEST_CASE("a maker has its table's own values, but for those that are given") {
    const Makers makers = stepOf(kSet +
                                 "estimator = 'photon-map'\nparams = { photons = 500, caustics = 'off' }\n"
                                 "specular = 256\n"
                                 "against = { estimator = 'path', depth = 0, specular = 3 }\n")
                              .values.makers;
    REQUIRE((makers.first && makers.second));
    CHECK(makers.first->estimator == "photon-map");
    CHECK(valueOf(*makers.first, "photons") == 500);
    CHECK(valueOf(*makers.first, "caustics") == 0);
    CHECK(valueOf(*makers.first, "radius") == valueOf(makerOf("photon-map"), "radius"));
    CHECK_FALSE(makers.first->depth.has_value());
    CHECK(makers.second->estimator == "path");
    CHECK(makers.second->depth == 0);
    CHECK(makers.first->specular == 256);
    CHECK(makers.second->specular == 3);
}

TEST_CASE("mirrors and glass events in a row are the maker's own, and another estimator does not keep them") {
    const std::string defaults = "[defaults]\nestimator = 'light'\nspecular = 0\n";
    const auto first = [&](const std::string& set) {
        return *stepOf(kHead + defaults + kStep + "[step.set]\n" + set).values.makers.first;
    };
    CHECK(first("params = { paths = 7 }\n").specular == 0);
    CHECK(first("specular = 1000\n").specular == 1000);
    CHECK(first("estimator = 'path'\n") == makerOf("path"));
    Maker few = makerOf("path");
    few.specular = 3;
    CHECK_FALSE(few == makerOf("path"));
}

TEST_CASE("a step without makers has none, and one with another estimator does not keep the old parameters") {
    CHECK(stepOf(kHead + kStep).values.makers == Makers{});
    const std::string defaults = "[defaults]\nestimator = 'light'\nparams = { paths = 7 }\n";
    const Maker kept =
        *stepOf(kHead + defaults + kStep + "[step.set]\nparams = { roulette = 2 }\n").values.makers.first;
    CHECK(valueOf(kept, "paths") == 7);
    CHECK(valueOf(kept, "roulette") == 2);
    CHECK(*stepOf(kHead + defaults + kStep + "[step.set]\nestimator = 'light'\n").values.makers.first ==
          makerOf("light"));
}

TEST_CASE("what tells two makers apart is in their titles") {
    Maker wide = makerOf("photon-map"), narrow = wide;
    CHECK(titleOf(wide, nullptr) == "Photon mapping");
    narrow.params[1] = 0.01;
    CHECK(titleOf(narrow, &wide) == "Photon mapping, radius 0.01");
    Maker shallow = makerOf("path");
    shallow.depth = 0;
    CHECK(titleOf(shallow, &wide) == "Path tracing, depth 0");
    shallow.specular = 256;
    CHECK(titleOf(shallow, &wide) == "Path tracing, depth 0, specular 256");
    CHECK(differenceOf(shallow, shallow) == "depth 0");
}

TEST_CASE("a wrong maker is told with its place") {
    check(kSet + "estimator = ^'pth'\n", {"estimator \"pth\" is unknown", "did you mean \"path\""});
    check(kSet + "estimator = ^3\n", {"\"estimator\""});
    check(kSet + "params = ^{ photons = 3 }\n", {"\"params\" need an \"estimator\""});
    const std::string photons = kSet + "estimator = 'photon-map'\nparams = ";
    check(photons + "{ photon = ^3 }\n", {"parameter of photon-map \"photon\" is unknown", "\"photons\""});
    check(photons + "{ photons = ^2.5 }\n", {"\"photons\"", "a whole number from"});
    check(photons + "{ radius = ^-1 }\n", {"\"radius\"", "a number from"});
    check(photons + "{ caustics = ^'maybe' }\n", {"\"caustics\"", "one of "});
    check(photons + "{ caustics = ^1 }\n", {"one of "});
    check(kSet + "against = ^{ estimator = 'path' }\n", {"needs an \"estimator\" that it stands beside"});
    const std::string path = kSet + "estimator = 'path'\nagainst = ";
    check(path + "^{ depth = 1 }\n", {"\"against\" has no \"estimator\""});
    check(path + "{ estimator = 'path', depth = ^65 }\n", {"\"depth\"", "64"});
    check(path + "{ estimator = 'path', specular = ^1001 }\n", {"\"specular\"", "1000"});
    check(kSet + "specular = ^3\n", {"\"specular\" needs an \"estimator\""});
    check(kSet + "estimator = 'path'\nspecular = ^-1\n", {"\"specular\"", "from 0 to 1000"});
    check(kSet + "estimator = 'path'\nspecular = ^'many'\n", {"\"specular\""});
    check(path + "{ estimator = 'path', ^seed = 1 }\n", {"unknown key \"seed\""});
}

TEST_CASE("a goal is read") {
    const Step step = stepOf(kGoal + "says = 'Go'\nreach = 'relativeError'\natMost = 0.01\n");
    REQUIRE(step.goal.has_value());
    CHECK(*step.goal == Goal{"Go", GoalQuantity::relativeError, Relation::atMost, 0.01});
    for (std::size_t i = 0; i < kGoalQuantities.size(); ++i)
        CHECK(static_cast<std::size_t>(kGoalQuantities[i].value) == i);
}

TEST_CASE("a wrong goal is told with its place") {
    const std::string head = kHead + kStep + "^[step.goal]\n";
    check(head + "says = 'Go'\nreach = 'rays'\n", {"the goal has no number"});
    check(kGoal + "says = 'Go'\nreach = 'rays'\natLeast = 1\natMost = ^2\n", {"the goal has two numbers"});
    check(head + "reach = 'rays'\natLeast = 1\n", {"\"says\""});
    check(kGoal + "says = 'Go'\nreach = ^'ray'\natLeast = 1\n", {"\"rays\""});
    check(kHead + kStep + "^[step.goal]\nsays = 'Go'\nreach = 'line'\n", {"no \"lines\""});
    check(kGoal + "says = 'Go'\nreach = 'line'\nlines = ^[]\n", {"is empty"});
    check(kHead + kStep + "^[step.goal]\nsays = 'Go'\nreach = 'line'\nlines = [3]\n", {"\"code\""});
    check(kHead + kStep + "^[step.goal]\nsays = 'Go'\nreach = 'drawn'\natLeast = 0.5\n", {"\"integrand\""});
    check(kGoal + "says = 'Go'\nreach = 'drawn'\natLeast = ^5\n", {"from 0 to 1"});
    check(kGoal + "says = 'Go'\nreach = 'drawn'\natMost = ^0.5\n", {"\"atLeast\""});
    check(kGoal + "says = 'Go'\nreach = 'line'\nlines = [3, ^99]\n", {"34"});
    check(kGoal + "says = 'Go'\nreach = 'line'\nlines = [3]\natLeast = ^1\n", {"has no number"});
    check(kGoal + "says = 'Go'\nreach = 'rays'\natLeast = 1\nlines = ^[3]\n", {"belong to a goal"});
    check(kGoal + "says = 'Go'\nreach = 'rays'\natLeast = ^nan\n", {"a finite number"});
}
