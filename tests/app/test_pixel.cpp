// Is every contribution of one pixel of the eye's strip shown, when it is clicked, and truthfully?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/doable.h"
#include "app/draw_text.h"
#include "app/number_words.h"
#include "app/sample_words.h"
#include "app/share_text.h"
#include "app/state_text.h"
#include "app/step_text.h"
#include "app/tree_json.h"
#include "lessons/input_error.h"
#include "rig.h"

using namespace halfdisk;

namespace {

constexpr std::uint32_t kPixel = 100;

/// A room with an eye, its strip shown.
AppState room(std::uint32_t samples = 32) {
    AppState state = openScene(courseLessons(), courseLessons() / "scenes/mirror_room.toml");
    Settings settings = state.settings;
    settings.samples = samples;
    settings.maxDepth = 2;
    apply(state, SetSettings{settings});
    apply(state, SetView{View::eye, true});
    return state;
}

void clickPixel(Rig& rig, std::uint32_t pixel) {
    const Rect strip = rig.driver.get("Stage/eye strip").rect;
    const float at = (static_cast<float>(pixel) + 0.5f) / static_cast<float>(kEyeStripPixels);
    rig.driver.clickAt(strip.left + at * strip.width(), strip.bottom - 10);
    rig.driver.frames(2);
    rig.settle();
}

/// Sum over the rows of what stands in the list.
double listed(const LightAnswer& answer) {
    double sum = 0.0;
    for (const SampleRow& row : *answer.rows) sum += gray(sampleValue(answer, row));
    return sum;
}

bool offers(const AppState& state, std::string_view name) {
    const std::vector<Doable> all = doables(state);
    return std::any_of(all.begin(), all.end(), [&](const Doable& one) { return one.name == name; });
}

}  // namespace

TEST_CASE("a click pins a pixel and lists its paths, a second one goes back to P") {
    Rig rig(room());
    rig.settle();
    REQUIRE_FALSE(rig.state().shows(View::samples));
    clickPixel(rig, kPixel);
    CHECK(rig.state().pinnedPixel == kPixel);
    CHECK(rig.state().shows(View::samples));
    const LightAnswer& answer = *rig.state().answer;
    REQUIRE(answer.pathRun);
    CHECK(pixelOf(answer) == kPixel);
    CHECK(answer.asked.run == Run::path);  // castRay has no half-disk at an eye
    CHECK(answer.rows->size() == 32);
    const double L = gray(answer.pathRun->estimate);
    REQUIRE(L > 0.0);
    CHECK(listed(answer) == doctest::Approx(32.0 * L).epsilon(1e-12));
    CHECK(pixelSumWords(answer).find(fmt::format("Pixel {}: 32 paths", kPixel)) == 0);
    CHECK(pixelSumWords(answer).ends_with(fmt::format("L = {} W/(m rad)", shown(L))));
    // The strip, of more passes, agrees.
    const Statistics strip = answer.pictures.eye->film.pixels[kPixel];
    CHECK(std::abs(gray(strip.mean) - L) < 5.0 * gray(*answer.pathRun->standardError) + 1e-9);
    clickPixel(rig, kPixel);
    CHECK_FALSE(rig.state().pinnedPixel);
    CHECK_FALSE(rig.state().answer->pathRun);
    CHECK(pixelOf(*rig.state().answer) == std::nullopt);
}

TEST_CASE("the rows of a pixel make its value, by each estimator that is recorded") {
    Rig rig(room(48));
    rig.apply(PinPixel{kPixel});
    for (const Named<Run>& run : kRuns) {
        if (run.value == Run::castRay) continue;
        CAPTURE(run.name);
        rig.apply(SetRun{run.value});
        rig.settle();
        const LightAnswer& answer = *rig.state().answer;
        CHECK(answer.asked.run == run.value);
        CHECK(pixelOf(answer) == kPixel);
        const PathRun& told = *answer.pathRun;
        REQUIRE(told.refusal.empty());
        const double sum = gray(told.estimate) * told.divisor;
        CHECK(std::abs(listed(answer) - sum) <= 1e-9 * sum);
        for (const SampleRow& row : *answer.rows)
            if (run.value != Run::photonMap && gray(row.adds) > 0.0) {
                CHECK(row.finds > 0);
                CHECK(row.word.front() == 'L');
                CHECK(row.word.back() == 'E');
            }
    }
}

TEST_CASE("where castRay is chosen a pixel's run is that of the strip's own estimator, if it is recorded") {
    AppState state = room();
    apply(state, PinPixel{kPixel});
    CHECK(state.shownRun() == Run::path);
    for (const auto& [estimator, run] :
         {std::pair{"light", Run::light}, std::pair{"bidirectional", Run::bidirectional},
          std::pair{"radiosity", Run::path}, std::pair{"cast-ray", Run::path}}) {
        apply(state, SetMakers{{makerOf(estimator), std::nullopt}});
        CHECK(state.shownRun() == run);
        CHECK(state.run == Run::castRay);
    }
    apply(state, SetRun{Run::light});
    CHECK(state.shownRun() == Run::light);
    apply(state, SetRun{Run::castRay});
    apply(state, PinPixel{});
    CHECK(state.shownRun() == Run::castRay);
}

TEST_CASE("Back to P, Escape, another scene, another place of P and a hidden strip all let go of the pixel") {
    Rig rig(room());
    const auto pin = [&] {
        rig.apply(PinPixel{kPixel});
        rig.settle();
        REQUIRE(rig.state().pinnedPixel == kPixel);
    };
    pin();
    rig.driver.click("Stage/Back to P");
    CHECK_FALSE(rig.state().pinnedPixel);
    pin();
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(rig.state().pinnedPixel);
    pin();
    rig.apply(MovePoint{{1, 0.3}});
    CHECK_FALSE(rig.state().pinnedPixel);
    pin();
    SceneDescription changed = rig.state().scene->description;
    changed.eye->fov *= 0.5;
    rig.apply(EditScene{changed, {}, false});
    CHECK_FALSE(rig.state().pinnedPixel);
    pin();
    rig.apply(Undo{});
    CHECK_FALSE(rig.state().pinnedPixel);
    pin();
    rig.apply(SetView{View::eye, false});
    CHECK_FALSE(rig.state().pinnedPixel);
    rig.apply(PinPixel{kPixel});  // not while it is hidden
    CHECK_FALSE(rig.state().pinnedPixel);
    rig.apply(SetView{View::eye, true});
    rig.apply(PinPixel{kEyeStripPixels});
    CHECK_FALSE(rig.state().pinnedPixel);
    pin();
    rig.apply(OpenScene{courseLessons() / "scenes/two_lamps.toml"});  // has no eye
    CHECK_FALSE(rig.state().pinnedPixel);
    rig.apply(SetView{View::eye, true});
    rig.apply(PinPixel{0});
    CHECK_FALSE(rig.state().pinnedPixel);
}

TEST_CASE("what was pinned is in the shared text") {
    AppState state = room();
    apply(state, PinPixel{kPixel});
    const std::string text = shareText(state);
    AppState other = openShared(courseLessons(), text);
    CHECK(other.pinnedPixel == kPixel);
    CHECK(shareText(other) == text);
    apply(state, PinPixel{});
    CHECK_FALSE(openShared(courseLessons(), shareText(state)).pinnedPixel);
    CHECK(shareText(state) != text);
    // Pasted where the strip is hidden there is none.
    AppState strict = room();
    ClassRules rules;
    addHidden(rules, "eye");
    setRules(strict, rules);
    apply(strict, OpenShared{text});
    CHECK(strict.banner.empty());
    CHECK_FALSE(strict.pinnedPixel);
}

TEST_CASE("class rules that hide the list are kept, the run is still the pixel's") {
    AppState state = room();
    ClassRules rules;
    addHidden(rules, "samples");
    setRules(state, rules);
    apply(state, PinPixel{kPixel});
    CHECK(state.pinnedPixel == kPixel);
    CHECK_FALSE(state.shows(View::samples));
    addHidden(rules, "eye");
    setRules(state, rules);
    CHECK_FALSE(state.pinnedPixel);
}

TEST_CASE("a lesson's step may begin with a pixel, and Reset finds it again") {
    Rig rig(openLesson(courseLessons(), LessonRef{"wasted-rays", 5}));
    rig.settle();
    const std::optional<std::uint32_t> begun = rig.state().currentStep()->values.pixel;
    REQUIRE(begun);
    CHECK(rig.state().pinnedPixel == begun);
    const LightAnswer& answer = *rig.state().answer;
    CHECK(pixelOf(answer) == begun);
    // As the step says: one path of all brings nearly all.
    double most = 0.0;
    for (const SampleRow& row : *answer.rows) most = std::max(most, gray(row.adds));
    CHECK(answer.rows->size() == 64);
    CHECK(most > 0.9 * gray(answer.pathRun->estimate));
    rig.apply(PinPixel{3});
    rig.apply(ResetStep{});
    CHECK(rig.state().pinnedPixel == begun);
    rig.apply(NextStep{});
    CHECK_FALSE(rig.state().pinnedPixel);
}

TEST_CASE("in a step without the list it goes again with the pixel") {
    AppState state = openLesson(courseLessons(), LessonRef{"wasted-rays", 4});
    REQUIRE_FALSE(state.shows(View::samples));
    apply(state, PinPixel{kPixel});
    CHECK(state.shows(View::samples));
    apply(state, PinPixel{kPixel + 1});
    CHECK(state.shows(View::samples));
    apply(state, PinPixel{});
    CHECK_FALSE(state.shows(View::samples));
}

TEST_CASE("a row's click goes to the path's end, hovering shows it, and steps walk through the pixel's run") {
    Rig rig(room());
    rig.apply(PinPixel{kPixel});
    rig.settle();
    const SampleRow row = rig.state().answer->rows->at(1);
    const std::string name = fmt::format("Stage/sample at {}", row.event);
    rig.driver.moveTo(name);
    rig.driver.frames(2);
    CHECK(rig.state().shownSample == row.event);
    rig.driver.click(name);
    CHECK(rig.state().playback.event == row.event);
    CHECK(rig.state().answer->pathRun->record.events[row.event - 1].path == 1);
    rig.driver.pressKey(Key::home);
    rig.driver.pressKey(Key::right);
    CHECK(rig.state().playback.event == 1);
    CHECK(rig.state().eventCount() == rig.state().answer->pathRun->record.events.size());
}

TEST_CASE("the list can be sorted, the largest first") {
    Rig rig(room());
    rig.apply(PinPixel{kPixel});
    rig.settle();
    const auto& rows = *rig.state().answer->rows;
    const auto most = std::max_element(
        rows.begin(), rows.end(), [](const auto& a, const auto& b) { return gray(a.adds) < gray(b.adds); });
    const auto top = [&](const SampleRow& row) {
        return rig.driver.get(fmt::format("Stage/sample at {}", row.event)).rect.top;
    };
    const float first = top(rows.front());
    rig.driver.click("Stage/Largest first");
    rig.driver.frames(2);
    CHECK(rig.state().largestFirst);
    CHECK(top(*most) == first);
}

TEST_CASE(
    "where two are compared, a click pins the pixel of the strip that it meets, and the list says whose") {
    AppState two = room();
    apply(two, SetMakers{{makerOf("path"), makerOf("light")}});
    Rig rig(std::move(two));
    rig.settle();
    clickPixel(rig, kPixel);
    CHECK(rig.state().pinnedSide == Side::first);
    CHECK(rig.state().answer->asked.run == Run::path);
    const double ofA = gray(rig.state().answer->pathRun->estimate);
    CHECK(whosePixel(*rig.state().answer).substr(0, 3) == "A: ");
    CHECK(rig.session.widgets.find(fmt::format("Stage/{}", whosePixel(*rig.state().answer))));

    const Rect strip = rig.driver.get("Stage/eye strip B").rect;
    const float at = (kPixel + 0.5f) / static_cast<float>(kEyeStripPixels);
    const auto clickB = [&] {
        rig.driver.clickAt(strip.left + at * strip.width(), strip.bottom - 10);
        rig.driver.frames(2);
        rig.settle();
    };
    clickB();
    const LightAnswer& answer = *rig.state().answer;
    CHECK(rig.state().pinnedPixel == kPixel);
    CHECK(rig.state().pinnedSide == Side::second);
    CHECK(answer.asked.run == Run::light);
    CHECK(gray(answer.pathRun->estimate) != ofA);
    CHECK(listed(answer) / static_cast<double>(answer.pathRun->divisor) ==
          doctest::Approx(gray(answer.pathRun->estimate)));
    CHECK(whosePixel(answer).substr(0, 3) == "B: ");
    CHECK(nlohmann::json::parse(treeJson(rig.state()))["pixelOf"] == "B");

    const AppState opened = openShared(courseLessons(), shareText(rig.state()));
    CHECK(opened.pinnedPixel == kPixel);
    CHECK(opened.pinnedSide == Side::second);

    rig.driver.pressKey(Key::period);  // along the same strip
    CHECK(rig.state().pinnedSide == Side::second);
    rig.driver.pressKey(Key::comma);
    rig.apply(SetRun{Run::path});
    CHECK(rig.state().shownRun() == Run::path);
    CHECK(whosePixel(*rig.state().answer).substr(0, 3) == "B: ");
    clickB();  // again: back to P
    CHECK_FALSE(rig.state().pinnedPixel);
    CHECK(rig.state().pinnedSide == Side::first);
    clickB();
    CHECK(rig.state().shownRun() == Run::light);  // another strip, its own run
    rig.apply(SetMakers{{makerOf("path"), std::nullopt}});
    CHECK(rig.state().pinnedPixel == kPixel);
    CHECK(rig.state().pinnedSide == Side::first);
}

TEST_CASE("two settings of one estimator: the pixel's run is that of the strip that was clicked") {
    AppState two = room();
    Maker shallow = makerOf("path");
    shallow.depth = 0;
    apply(two, SetMakers{{makerOf("path"), shallow}});
    Rig rig(std::move(two));
    rig.apply(PinPixel{kPixel, Side::first});
    rig.settle();
    const std::size_t deep = rig.state().answer->pathRun->record.events.size();
    rig.apply(PinPixel{kPixel, Side::second});
    rig.settle();
    CHECK(rig.state().answer->pathRun->record.events.size() < deep);
}

TEST_CASE("a pixel's run follows as many mirrors in a row as its strip") {
    const auto lessons = courseLessons();
    AppState state = openScene(lessons, lessons / "scenes/mirror_room.toml");
    Maker blind = makerOf("path");
    blind.specular = 0;
    apply(state, SetView{View::eye, true});
    apply(state, SetRun{Run::path});
    apply(state, SetMakers{{makerOf("path"), blind}});
    Rig rig(std::move(state));
    const auto cutOf = [&](Side side) {
        std::uint64_t cut = 0;
        for (std::uint32_t pixel = 0; pixel < kEyeStripPixels; pixel += 32) {
            rig.apply(PinPixel{pixel, side});
            rig.settle();
            cut += rig.state().answer->pathRun->counts.cut;
        }
        return cut;
    };
    CHECK(cutOf(Side::first) == 0);
    CHECK(cutOf(Side::second) > 0);
}

TEST_CASE("a step's pixel is pinned in another scene too, or its absence is told") {
    const auto lessons = courseLessons();
    Lesson lesson = openLesson(lessons, LessonRef{"wasted-rays", 1}).lesson.value();
    const auto step = std::find_if(lesson.steps.begin(), lesson.steps.end(),
                                   [](const Step& one) { return one.values.pixel.has_value(); });
    REQUIRE(step != lesson.steps.end());
    const LessonRef ref{"wasted-rays", static_cast<int>(step - lesson.steps.begin()) + 1};
    const AppState seen = openLesson(lessons, ref, lessons / "scenes/mirror_room.toml");
    CHECK(seen.pinnedPixel == step->values.pixel);
    CHECK(seen.notice.empty());
    const AppState unseen = openLesson(lessons, ref, lessons / "scenes/small_room.toml");
    CHECK_FALSE(unseen.pinnedPixel);
    CHECK(unseen.notice.find("no eye") != std::string::npos);
}

TEST_CASE("what rounding leaves beside a bright path is about nothing") {
    Rig rig(room());
    rig.apply(PinPixel{kPixel});
    rig.settle();
    SampleRow row = rig.state().answer->rows->front();
    for (const auto& [adds, words] : {std::pair{1e-66, "\u2248 0"}, std::pair{0.0, "0"}}) {
        row.adds = Rgb(adds);
        CHECK(sampleNumber(*rig.state().answer, row, 1.0) == words);
    }
    row.adds = Rgb(1e-3);
    CHECK(sampleNumber(*rig.state().answer, row, 1.0) != "\u2248 0");
}

TEST_CASE("keys move into the strip and along it, and the palette names every pixel") {
    Rig rig(room());
    rig.settle();
    rig.driver.pressKey(Key::period);
    CHECK(rig.state().pinnedPixel == kEyeStripPixels / 2);
    rig.driver.pressKey(Key::period);
    CHECK(rig.state().pinnedPixel == kEyeStripPixels / 2 + 1);
    rig.driver.pressKey(Key::shift, Key::comma);
    CHECK(rig.state().pinnedPixel == kEyeStripPixels / 2 - 9);
    rig.apply(PinPixel{0});
    rig.driver.pressKey(Key::comma);
    CHECK(rig.state().pinnedPixel == 0u);
    CHECK(offers(rig.state(), "Back to P from the pixel"));
    CHECK(offers(rig.state(), "One pixel to the right"));
    CHECK_FALSE(offers(rig.state(), "One pixel to the left"));
    CHECK(offers(rig.state(), "Look into pixel 255 of the eye's strip"));
    CHECK_FALSE(offers(rig.state(), "Look into pixel 0 of the eye's strip"));
    CHECK_FALSE(offers(rig.state(), "Look into pixel 256 of the eye's strip"));
    for (const Doable& one : doables(rig.state())) {
        if (!std::holds_alternative<PinPixel>(one.command)) continue;
        AppState after = rig.state();
        apply(after, one.command);
        CHECK(after.pinnedPixel != rig.state().pinnedPixel);
    }
    rig.apply(SetView{View::eye, false});
    CHECK_FALSE(offers(rig.state(), "Look into pixel 7 of the eye's strip"));
    rig.driver.pressKey(Key::period);
    CHECK_FALSE(rig.state().pinnedPixel);
}

TEST_CASE("what is exported says that it is a pixel's run, in its unit") {
    using Json = nlohmann::json;
    Rig rig(room());
    rig.settle();
    Json tree = Json::parse(treeJson(rig.state()));
    CHECK(tree["pixel"].is_null());
    CHECK(tree["unit"] == "W/m");
    CHECK(stateText(rig.state()).find("W/(m rad). Most comes") == std::string::npos);
    rig.apply(PinPixel{kPixel});
    rig.settle();
    tree = Json::parse(treeJson(rig.state()));
    CHECK(tree["pixel"] == kPixel);
    CHECK(tree["unit"] == "W/(m rad)");
    CHECK(tree["run"] == "path");
    CHECK(tree["exact"].is_null());
    const PathRun& run = *rig.state().answer->pathRun;
    CHECK(tree["estimate"]["total"][0].get<double>() == run.estimate.x);
    double sum = 0.0;
    for (const Json& event : tree["events"]) sum += event["value"][0].get<double>();
    CHECK(sum / run.divisor == doctest::Approx(run.estimate.x).epsilon(1e-12));
    const std::string words = stateText(rig.state());
    CHECK(words.find(fmt::format("for pixel {} of the eye's strip", kPixel)) != std::string::npos);
    CHECK(words.find(fmt::format("It says L = {} W/(m rad)", shown(run.estimate))) != std::string::npos);
    CHECK(words.find("It says E") == std::string::npos);
    bool told = false;
    for (const NumberWords& number : numberWords(rig.state())) {
        if (number.name.find("estimate of E") != std::string::npos) FAIL("E of a pixel");
        if (number.name.find("estimate of L, pixel") == 0)
            told = number.value.find(" W/(m rad)") != std::string::npos;
    }
    CHECK(told);
}

TEST_CASE("the words of a pixel's steps speak of the eye, not of P") {
    Rig rig(room(8));
    for (const bool pinned : {false, true}) {
        if (pinned) rig.apply(PinPixel{kPixel});
        for (const Run run : {Run::light, Run::bidirectional, Run::photonMap}) {
            rig.apply(SetRun{run});
            rig.settle();
            std::size_t ofP = 0, ofEye = 0;
            for (std::size_t i = 1; i <= std::min<std::size_t>(rig.state().eventCount(), 400); ++i) {
                apply(rig.session.state, SetEvent{i});
                const StepText words = describeStep(rig.state());
                const std::string all = words.where + words.what;
                ofP += all.find("from P") != std::string::npos || all.find("to P") != std::string::npos;
                ofEye += all.find("the eye") != std::string::npos;
            }
            CAPTURE(pinned);
            CAPTURE(static_cast<int>(run));
            CHECK((ofP > 0) == !pinned);
            CHECK((ofEye > 0) == pinned);
        }
    }
}

TEST_CASE("a click on the profile brings P to that bin, where P may be moved, and the list is P's") {
    AppState state = room();
    apply(state, SetView{View::profile, true});
    apply(state, SetView{View::integrand, false});
    Rig rig(std::move(state));
    rig.apply(PinPixel{kPixel});
    rig.apply(SetView{View::samples, false});
    rig.settle();
    const Rect plot = rig.driver.get("Stage/profile").target;
    rig.driver.clickAt(plot.left + 0.7f * plot.width(), plot.top + 0.6f * plot.height());
    rig.driver.frames(2);
    CHECK_FALSE(rig.state().pinnedPixel);
    CHECK(rig.state().at.t > 0.55);
    CHECK(rig.state().at.t < 0.8);
    const auto bins = static_cast<double>(rig.state().answer->pictures.profile->film.pixels.size());
    const double place = rig.state().at.t * bins;
    CHECK(place - std::floor(place) == doctest::Approx(0.5));
    // A step that leaves P alone leaves it here too.
    const WallPoint at = rig.state().at;
    rig.session.state.rules.lock(Control::point);
    rig.driver.clickAt(plot.left + 0.3f * plot.width(), plot.top + 0.6f * plot.height());
    CHECK(rig.state().at == at);
}
