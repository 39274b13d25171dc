// Does a copied text show another what one sees, to the bit, and does a damaged one do no harm?
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <random>

#include "app/edit_commands.h"
#include "app/packed_text.h"
#include "app/picture.h"
#include "app/share_text.h"
#include "lessons/input_error.h"
#include "rig.h"

using namespace halfdisk;

namespace {

AppState changedState() {
    AppState state = openLesson(testLessons(), LessonRef{"controls", 10});
    apply(state, MovePoint{{2, 0.1875}});
    Settings settings = state.settings;
    settings.samples = 7;
    settings.seed = UINT64_MAX;
    settings.sampler = Sampler::stratified;
    settings.defects.set(Defect::pdf, true);
    apply(state, SetSettings{settings});
    apply(state, SetView{View::histogram, true});
    Maker photons = makerOf("photon-map");
    photons.params[1] = 0.1;
    photons.depth = 3;
    photons.specular = 256;
    apply(state, SetMakers{{photons, makerOf("path"), Budget::time}});
    apply(state, SetView{View::difference, true});
    return state;
}

void checkSame(const AppState& a, const AppState& b) {
    CHECK(a.scene->description == b.scene->description);
    CHECK(a.settings == b.settings);
    CHECK(a.at == b.at);
    CHECK(a.show == b.show);
    CHECK(a.makers == b.makers);
    CHECK(a.playback == b.playback);
    CHECK(a.step == b.step);
    CHECK(a.lesson.has_value() == b.lesson.has_value());
    if (a.lesson && b.lesson) CHECK(a.lesson->slug == b.lesson->slug);
}

void refused(const std::string& text) {
    try {
        openShared(testLessons(), text);
        FAIL("taken");
    } catch (const InputError& error) {
        CHECK_FALSE(std::string(error.what()).empty());
    }
}

}  // namespace

TEST_CASE("a state is the same on the other side, and so is its text") {
    for (const bool edited : {false, true}) {
        AppState state = changedState();
        if (edited) {
            SceneDescription scene = state.scene->description;
            moveBy(scene, {ThingKind::shape, 0}, {0.0, 1.0 / 3.0});
            apply(state, EditScene{scene, std::nullopt, false});
        }
        const std::string text = shareText(state);
        CHECK(isShareText(text));
        CHECK(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.") ==
              std::string::npos);
        const AppState other = openShared(testLessons(), text);
        checkSame(state, other);
        CHECK(shareText(other) == text);
        std::string broken = " ";  // as a mail would break it
        for (std::size_t i = 0; i < text.size(); ++i) {
            broken += text[i];
            if (i % 40 == 39) broken += '\n';
        }
        checkSame(state, openShared(testLessons(), broken));
    }
}

TEST_CASE("a text is short where the scene is the lesson's own") {
    CHECK(shareText(openLesson(testLessons(), LessonRef{"controls", 1})).size() < 300);
}

TEST_CASE("a scene without a lesson goes along whole") {
    AppState state = openScene(testLessons(), testLessons() / "scenes/box.toml");
    apply(state, MovePoint{{1, 0.75}});
    checkSame(state, openShared(testLessons(), shareText(state)));
}

TEST_CASE("the same text gives the same picture, to the bit") {
    AppState state = changedState();
    state.makers.equal = Budget::rays;  // of equal times the pictures would depend on the machine
    const std::string text = shareText(state);
    HeadlessHost host(640, 480);
    const Image a = pictureOf(state, host), b = pictureOf(openShared(testLessons(), text), host);
    CHECK(a.rgba == b.rgba);
}

TEST_CASE("what came as a text is unsaved until it is saved, and obeys what is locked") {
    AppState state = changedState();
    SceneDescription scene = state.scene->description;
    moveBy(scene, {ThingKind::shape, 0}, {0.0, 0.25});
    apply(state, EditScene{scene, std::nullopt, false});
    const std::string text = shareText(state);
    Rig rig("controls:1");
    ClassRules rules;
    addLock(rules, "samples=3");
    addHidden(rules, "histogram");
    setRules(rig.session.state, rules);
    rig.apply(OpenShared{text});
    CHECK(rig.state().scene->description == scene);
    CHECK(isEdited(rig.state()));
    CHECK(rig.state().settings.samples == 3);
    CHECK(rig.state().settings.seed == UINT64_MAX);
    CHECK_FALSE(rig.state().shows(View::histogram));
    AppState alone =
        openShared(testLessons(), shareText(openScene(testLessons(), testLessons() / "scenes/box.toml")));
    CHECK(isEdited(alone));
    CHECK(alone.sceneOverride.empty());
}

TEST_CASE("a damaged text is refused, whatever the damage") {
    const std::string text = shareText(changedState());
    refused("");
    refused("halfdisk.");
    refused("hello");
    refused(text.substr(0, text.size() - 3));
    std::mt19937 dice(1);
    int taken = 0;
    constexpr int kTries = 2000;
    for (int i = 0; i < kTries; ++i) {
        std::string damaged = text;
        damaged[9 + dice() % (damaged.size() - 9)] = "ABCxyz019-_"[dice() % 11];
        try {
            const AppState state = openShared(testLessons(), damaged);
            REQUIRE(state.at.segment < state.scene->scene.segments.size());
            ++taken;  // the letter was the same one
        } catch (const InputError&) {
        }
    }
    CHECK(taken < kTries / 10);
}

TEST_CASE("a number that is wrong in a whole text is told by its name, with what was expected") {
    const std::string text = shareText(changedState());
    constexpr std::string_view kPrefix = "halfdisk.";
    const auto json = nlohmann::json::parse(*unpackedText(text.substr(kPrefix.size()), 1u << 20));
    const auto told = [&](const char* key, const nlohmann::json& value) {
        nlohmann::json changed = json;
        changed[key] = value;
        try {
            openShared(testLessons(), std::string(kPrefix) + packedText(changed.dump()));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(told("samples", json["samples"]).empty());
    CHECK(told("samples", 0) ==
          fmt::format("the shared text: \"samples\" is 0, expected a whole number from 1 to {}",
                      kMostLessonSamples));
    CHECK(told("t", 1.5) == "the shared text: \"t\" is 1.5, expected a number from 0 to 1");
    CHECK(told("sampler", "dice").find("\"sampler\" is \"dice\", expected one of uniform, ") !=
          std::string::npos);
    CHECK(told("depth", "deep").find("\"depth\" is \"deep\"") != std::string::npos);
    CHECK(told("first", {{"estimator", "guess"}, {"params", nlohmann::json::array()}})
              .find("\"estimator\" is \"guess\"") != std::string::npos);
}

TEST_CASE("a text that would unpack into more than a scene may take is refused") {
    AppState state = openScene(testLessons(), testLessons() / "scenes/box.toml");
    SceneDescription scene = state.scene->description;
    scene.title = std::string(17u << 20, 'x');  // packs into some kilobytes
    state.scene = std::make_shared<const PreparedScene>(scene);
    refused(shareText(state));
}

TEST_CASE("copied and pasted by keys; what is pasted wrong leaves all as it was") {
    Rig rig(changedState());
    rig.driver.pressKey(Key::ctrl, Key::c);
    const SceneDescription scene = rig.state().scene->description;
    rig.apply(GoTo{"field", 0});
    rig.driver.pressKey(Key::ctrl, Key::v);
    rig.driver.frames(2);
    CHECK(rig.state().scene->description == scene);
    CHECK(rig.state().settings.samples == 7);
    const AppState before = rig.state();
    rig.apply(OpenShared{"halfdisk.xyz"});
    CHECK(rig.state().settings == before.settings);
    CHECK(rig.state().banner.find("damaged") != std::string::npos);
}
