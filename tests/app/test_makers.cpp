// Do two estimators stand side by side as promised, and does a goal tell when it is reached?
#include <doctest/doctest.h>

#include <cmath>

#include "app/exact_stages.h"
#include "app/goal_check.h"
#include "app/picture_stages.h"
#include "app/strip_difference.h"
#include "rig.h"

using namespace halfdisk;

namespace {

constexpr const char* kEstimatorStep = "controls:9";
constexpr const char* kParamsStep = "controls:10";

bool showsText(const Rig& rig, std::string_view words) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.kind == WidgetKind::text && widget.name.find(words) != std::string::npos) return true;
    return false;
}

const LightPicture& profile(const Rig& rig, bool second = false) {
    return *(second ? rig.state().answer->against : rig.state().answer->pictures).profile;
}

}  // namespace

TEST_CASE("choosing an estimator makes the pictures anew, and only them") {
    Rig rig(kEstimatorStep);
    const auto record = rig.state().answer->record;
    REQUIRE(rig.state().answer->pictures.profile);
    CHECK_FALSE(rig.state().makers.first.has_value());
    rig.driver.click("Controls/estimator");
    rig.driver.frames(2);
    rig.driver.click("Controls/estimator/radiosity");
    rig.settle();
    REQUIRE(rig.state().makers.first.has_value());
    CHECK(rig.state().makers.first->estimator == "radiosity");
    CHECK(rig.state().answer->asked.makers == rig.state().makers);
    CHECK(rig.state().playback.event == 0);
    CHECK(showsText(rig, "Radiosity"));
}

TEST_CASE("Compare puts a second one beside it, with the same white; again, and it is gone") {
    Rig rig(kEstimatorStep);
    CHECK(rig.state().answer->against.field == nullptr);
    rig.driver.click("Controls/Compare");
    rig.settle();
    REQUIRE((rig.state().answer->against.field && rig.state().answer->against.profile));
    CHECK(rig.state().answer->against.field->white == rig.state().answer->pictures.field->white);
    CHECK(showsText(rig, "A: "));
    CHECK(showsText(rig, "B: "));
    rig.driver.click("Controls/Compare");
    rig.settle();
    CHECK(rig.state().answer->against.field == nullptr);
    CHECK_FALSE(rig.state().makers.second.has_value());
}

TEST_CASE("the line between two fields is dragged, within the canvas") {
    Rig rig(kParamsStep);
    const CanvasRect canvas = rig.canvas();
    const float middle = canvas.min.x + 0.5f * canvas.width();
    const auto drag = [&](float from, float to) {
        rig.driver.moveTo(from, canvas.min.y + 100);
        rig.driver.press();
        rig.driver.moveTo((from + to) / 2, canvas.min.y + 100);
        rig.driver.moveTo(to, canvas.min.y + 100);
        rig.driver.release();
        rig.driver.frames(2);
    };
    drag(middle, middle + 60);
    CHECK(rig.state().split == doctest::Approx(0.5f + 60 / canvas.width()).epsilon(0.02));
    CHECK(rig.state().fitCamera);
    drag(middle + 60, canvas.max.x + 500);
    CHECK(rig.state().split == 1.0f);
    rig.apply(ResetStep{});
    CHECK(rig.state().split == 0.5f);
}

TEST_CASE("a second maker may have a depth of its own") {
    Rig rig(kParamsStep);
    REQUIRE(rig.state().makers.second);
    CHECK(rig.state().makers.second->depth == 0);
    double first = 0.0, second = 0.0;
    for (const Rgb& bin : profile(rig).film.pixels.mean) first += bin.x;
    for (const Rgb& bin : profile(rig, true).film.pixels.mean) second += bin.x;
    CHECK(first > 1.02 * second);  // what the walls scatter
    rig.settings().maxDepth = 0;
    ++rig.session.state.questionId;
    rig.settle();
    const PixelStatistics &light = profile(rig).film.pixels, &path = profile(rig, true).film.pixels;
    int off = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double error = std::hypot(light[i].standardError().x, path[i].standardError().x);
        if (std::abs(light.mean[i].x - path.mean[i].x) > 4.0 * error) ++off;
    }
    CHECK(off <= 1);  // of 96 bins; one in 16 000 by chance each
}

TEST_CASE("parameters are typed within their range, and change the pictures") {
    Rig rig(kParamsStep);
    rig.driver.typeNumber("Controls/paths", "5000");
    CHECK(rig.state().makers.first->params[0] == 5000);
    rig.driver.typeNumber("Controls/paths", "-3");
    CHECK(rig.state().makers.first->params[0] == 0);
    CHECK(rig.state().makers.second.has_value());
    rig.settle();
    CHECK(rig.state().answer->asked.makers == rig.state().makers);
}

TEST_CASE("a profile follows P to another wall, and stays while P moves along its own") {
    Rig rig(kEstimatorStep);
    const auto before = rig.state().answer->pictures.profile;
    rig.apply(MovePoint{{rig.state().at.segment, 0.9}});
    rig.settle();
    CHECK(rig.state().answer->pictures.profile == before);
    rig.apply(MovePoint{{rig.state().at.segment + 1, 0.5}});
    rig.settle();
    CHECK(std::get<Profile>(profile(rig).sensor).segments ==
          std::vector<std::uint32_t>{rig.state().at.segment});
}

TEST_CASE("a goal is reached when its number is, and not by an older answer") {
    Rig rig(kParamsStep);
    const Goal goal = *rig.state().currentStep()->goal;
    const auto value = valueOf(goal, rig.state());
    REQUIRE(value.has_value());
    CHECK(isReached(goal, *value));
    CHECK(showsText(rig, "Reached!"));
    ++rig.session.state.questionId;
    CHECK_FALSE(valueOf(goal, rig.state()).has_value());
    for (const Named<GoalQuantity>& quantity : kGoalQuantities) {
        // These wait for what the reader does: test_answers.cpp.
        if (quantity.value == GoalQuantity::line || quantity.value == GoalQuantity::drawn) continue;
        rig.settle();
        const auto found = valueOf({"", quantity.value, Relation::atLeast, 0.0}, rig.state());
        REQUIRE_MESSAGE(found.has_value(), quantity.name);
        CHECK(*found > 0.0);
        CHECK_FALSE(isReached({"", quantity.value, Relation::atMost, 0.5 * *found}, *found));
        CHECK(isReached({"", quantity.value, Relation::atMost, 2.0 * *found}, *found));
    }
}

TEST_CASE("ways of light are drawn and counted") {
    Rig rig(kParamsStep);
    REQUIRE(rig.state().answer->ways);
    CHECK(rig.state().answer->ways->size() == kWaysFollowed);
    CHECK(showsText(rig, "2000 paths of light followed"));
}

TEST_CASE(
    "two at equal rays have as many, two at equal time take as long, and the second kind is told in "
    "seconds") {
    Rig rig(kEstimatorStep);
    rig.driver.click("Controls/Compare");
    rig.setEffort(1.0);
    const auto rays = [&](bool second) { return static_cast<double>(profile(rig, second).film.counts.rays); };
    const auto seconds = [&](bool second) { return profile(rig, second).seconds; };
    CHECK(rays(false) >= 1.2e6);
    CHECK(rays(true) >= 1.2e6);
    CHECK_FALSE(showsText(rig, " s\n"));
    rig.scrollTo("Controls/equal", "Controls/");
    rig.driver.click("Controls/equal");
    rig.driver.frames(2);
    rig.driver.click("Controls/equal/time");
    rig.settle();
    CHECK(rig.state().makers.equal == Budget::time);
    // A second each, and one pass of the last batch beyond it at most.
    for (const bool second : {false, true}) {
        CHECK(seconds(second) >= 1.0);
        CHECK(profile(rig, second).complete);
    }
    CHECK(showsText(rig, " s\n"));
}

TEST_CASE(
    "where differences are shown the error stands beside the noise, and both agree for an unbiased one") {
    Rig rig("controls:1");
    rig.apply(UnlockAll{true});
    rig.apply(SetView{View::profile, true});
    rig.settle();
    const auto error = [&](std::size_t side) { return errorOf(*rig.state().answer, View::profile, side); };
    CHECK_FALSE(error(0));
    CHECK_FALSE(showsText(rig, ", error "));
    rig.scrollTo("Controls/Difference", "Controls/");
    rig.driver.click("Controls/Difference");
    rig.settle();
    REQUIRE(error(0));
    CHECK(showsText(rig, ", error "));
    // The error's square is a sum of 64 squares of what has the noise as its standard deviation.
    CHECK(*error(0) < 1.6 * *profile(rig).noise + 1e-3);
    Maker direct = makerOf("path");
    direct.depth = 0;
    rig.apply(SetMakers{{makerOf("path"), direct}});
    rig.settle();
    // Each is held against the exact picture of its own depth.
    REQUIRE((error(0) && error(1)));
    const auto mean = [](const std::vector<Rgb>& pixels) {
        double sum = 0.0;
        for (const Rgb& pixel : pixels) sum += gray(pixel);
        return sum;
    };
    const auto& exact = rig.state().answer->exactPictures;
    if (rig.state().settings.maxDepth > 0) CHECK(mean(*exact[1].profile) < mean(*exact[0].profile));
    CHECK(*error(1) < 1.6 * profile(rig, true).noise.value_or(0.0) + 1e-3);
}

TEST_CASE(
    "where two are compared the field's error stands beside its noise, each held against its own depth") {
    Rig rig("controls:1");
    rig.apply(UnlockAll{true});
    rig.apply(SetView{View::field, true});
    rig.setEffort(1.0);
    const auto error = [&](std::size_t side) { return errorOf(*rig.state().answer, View::field, side); };
    CHECK_FALSE(error(0));
    Maker direct = makerOf("light"), solved = makerOf("radiosity");
    direct.depth = 0;
    solved.params[1] = 1.0;  // all bounces
    for (const Maker& maker : {direct, solved}) {
        rig.apply(SetMakers{{makerOf("light"), maker}});
        rig.settle();
        REQUIRE((error(0) && error(1)));
        const auto noise = [&](const PictureSet& set) { return set.field->noise.value_or(0.0); };
        // A root mean square of 400 cells: by 4 standard deviations of itself, and what the cells near a
        // lamp, where noise is uneven, add.
        CHECK(*error(0) < 1.6 * noise(rig.state().answer->pictures) + 2e-3);
        CHECK(*error(1) < 1.6 * noise(rig.state().answer->against) + 2e-3);
    }
    const auto sum = [&](std::size_t side) {
        double all = 0.0;
        for (const Rgb& cell : rig.state().answer->exactPictures[side].field->mean) all += gray(cell);
        return all;
    };
    CHECK(sum(1) > 1.01 * sum(0));  // light of all bounces, and of the first ones
}

TEST_CASE("what takes long to prepare has a coarse first look, which gives way to what was asked for") {
    const AppState state = openLesson(courseLessons(), LessonRef{"other-roads", 1});
    LightAnswer answer;
    answer.asked = {.id = 1, .scene = state.scene, .at = state.at, .settings = state.settings};
    answer.asked.makers = {makerOf("radiosity"), makerOf("path")};
    answer.asked.pictures.set(View::field, true);
    answer.asked.pictures.set(View::profile, true);
    PictureCache cache;
    std::vector<std::array<bool, 2>> looks;
    const std::atomic<bool> cancelled = false;
    refinePictures(
        answer, cache, cancelled,
        [&] {
            const auto& field = answer.pictures.field;
            const auto& profile = answer.pictures.profile;
            looks.push_back({field && field->firstLook, profile && profile->firstLook});
            if (field && field->firstLook) {
                CHECK(std::get<Field>(field->sensor).width == 40);
                CHECK_FALSE(field->complete);
                CHECK(field->film.passes == 1);
            }
        },
        1);
    CHECK(std::any_of(looks.begin(), looks.end(), [](const auto& look) { return look[0] && look[1]; }));
    REQUIRE_FALSE(looks.empty());
    CHECK_FALSE((looks.back()[0] || looks.back()[1]));
    CHECK(std::get<Field>(answer.pictures.field->sensor).width == 160);
    CHECK(answer.pictures.field->film.passes == 1);
    REQUIRE(answer.against.field);
    CHECK_FALSE(answer.against.field->firstLook);
}

TEST_CASE("the eye's strip has its difference from the exact one below it, and a legend") {
    Rig rig("controls:1");
    rig.apply(OpenScene{courseLessons() / "scenes/diffuse_room.toml"});
    rig.apply(SetView{View::eye, true});
    rig.settle();
    CHECK(rig.session.widgets.find("Stage/eye strip exact") == nullptr);
    const float before = rig.driver.get("Stage/eye strip").rect.height();
    rig.apply(SetView{View::difference, true});
    rig.settle();
    CHECK(rig.session.widgets.find("Stage/eye strip exact") != nullptr);
    CHECK(rig.driver.get("Stage/eye strip").rect.height() > before);
    const StripDifferences found = stripDifferences(rig.state());
    const std::size_t pixels = rig.state().answer->pictures.eye->film.pixels.size();
    CHECK(found.exact.size() == pixels);
    CHECK(found.difference[0].size() == pixels);
    CHECK(found.difference[1].empty());
    CHECK(found.share <= 0.2);
    CHECK(found.share > 0.0);

    // A scene without an exact answer says so.
    rig.apply(OpenScene{courseLessons() / "scenes/glass_disk.toml"});
    rig.apply(SetView{View::eye, true});
    rig.apply(SetView{View::difference, true});
    rig.settle();
    CHECK(rig.session.widgets.find("Stage/eye strip exact") == nullptr);
    CHECK(stripDifferences(rig.state()).exact.empty());
}
