// Does any sequence of input and commands leave the program whole? Seeded: the same events in every run.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#include "rig.h"

using namespace halfdisk;

namespace {

/// Of each quarter; HALFDISK_RANDOM_EVENTS says how many else.
int eventCount() {
    const char* asked = std::getenv("HALFDISK_RANDOM_EVENTS");
    constexpr int kUsual = 1250;
    return asked ? std::max(1, std::atoi(asked)) : kUsual;
}

/// The standard fixes what this engine gives, but not what the distributions do.
struct Dice {
    std::mt19937 engine;

    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine() % n); }
    float between(float a, float b) { return a + (b - a) * static_cast<float>(below(100'001)) / 100'000.0f; }
    bool once(std::uint32_t in) { return below(in) == 0; }
};

/// What is saved by chance under a name without a folder goes there.
struct Within {
    std::filesystem::path before = std::filesystem::current_path();

    explicit Within(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
    ~Within() { std::filesystem::current_path(before); }
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;
};

/// Files that a hand might drop on the window.
std::vector<std::filesystem::path> garbage(const std::filesystem::path& folder) {
    const char* const texts[] = {"",          "\xff\xfe\x01", "[[segment]]",
                                 "title = 3", "a = [[[[[[[[", "[[step]]\n"};
    std::vector<std::filesystem::path> files{folder / "missing.toml",
                                             folder,
                                             "",
                                             folder / "scenes/box.toml",
                                             folder / "scenes/field.toml",
                                             folder / "02-field.toml",
                                             folder / "03-broken.toml"};
    for (const char* text : texts) {
        files.push_back(folder / ("garbage" + std::to_string(files.size()) + ".toml"));
        std::ofstream(files.back(), std::ios::binary) << text;
    }
    return files;
}

Settings randomSettings(Dice& dice) {
    Settings settings;
    settings.samples = dice.once(20) ? 4096 : 1 + dice.below(64);
    settings.maxDepth = dice.once(20) ? 8 : dice.below(3);
    settings.seed = dice.engine();
    settings.sampler = kSamplers[dice.below(3)].value;
    settings.emitters = kEmitters[dice.below(3)].value;
    if (dice.once(3)) settings.defects.bits = static_cast<std::uint8_t>(dice.below(128));
    return settings;
}

Maker randomMaker(Dice& dice) {
    const EstimatorInfo& info = *estimators()[dice.below(static_cast<std::uint32_t>(estimators().size()))];
    Maker maker = makerOf(info.id);
    for (std::size_t i = 0; i < info.params.size(); ++i) {
        const ParamInfo& param = info.params[i];
        if (!param.choices.empty())
            maker.params[i] = dice.below(static_cast<std::uint32_t>(param.choices.size()));
    }
    if (dice.once(3)) maker.depth = dice.below(4);
    if (dice.once(3)) maker.specular = dice.once(2) ? dice.below(3) : 1000;
    return maker;
}

/// Something done to a thing, or a new one; it may be more than a scene can hold.
EditScene randomEdit(Dice& dice, const AppState& state) {
    EditScene edit{state.scene->description, state.editing.selected, dice.once(3)};
    const std::vector<Thing> things = thingsOf(edit.scene);
    const Vec2 place(dice.between(-2, 5), dice.between(-2, 5));
    const double far = dice.once(20) ? 1e12 : 1.0;
    if (things.empty() || dice.once(4)) {
        const Tool tool = kTools[dice.below(static_cast<std::uint32_t>(kTools.size()))].value;
        if (const auto added = addThing(edit.scene, tool, place, far * Vec2(dice.between(-2, 5), place.y)))
            edit.selected = added;
        return edit;
    }
    const Thing thing = things[dice.below(static_cast<std::uint32_t>(things.size()))];
    edit.selected = thing;
    switch (dice.below(7)) {
        case 0:
            moveBy(edit.scene, thing, far * place);
            break;
        case 1: {
            const auto handles = static_cast<std::uint32_t>(handlesOf(edit.scene, thing).size());
            if (handles > 0) pullHandle(edit.scene, thing, dice.below(handles), far * place);
            break;
        }
        case 2:
            turnBy(edit.scene, thing, dice.between(-400, 400));
            break;
        case 3:
            scaleBy(edit.scene, thing, dice.once(10) ? 1e-9 : static_cast<double>(dice.between(0.5f, 2.0f)));
            break;
        case 4:
            edit.selected = copyOf(edit.scene, thing, place);
            break;
        case 5:
            remove(edit.scene, thing);
            break;
        default:
            flip(edit.scene, thing);
            if (thing.kind == ThingKind::shape)
                edit.scene.shapes[thing.index].material = addMaterial(edit.scene, dice.below(5));
    }
    return edit;
}

Selection randomSelection(Dice& dice, const AppState& state) {
    Selection some;
    for (const Thing thing : thingsOf(state.scene->description))
        if (dice.once(2)) some.add(thing);
    if (dice.once(5)) some.add(Thing{static_cast<ThingKind>(dice.below(3)), dice.below(600)});
    return some;
}

Command randomEditing(Dice& dice, const AppState& state) {
    switch (dice.below(14)) {
        case 5:
        case 6:
            return SelectThings{randomSelection(dice, state)};
        case 7:
            return MoveSelected{Vec2(dice.between(-1, 1), dice.once(20) ? 1e12 : 0.1), dice.once(2)};
        case 8:
            return SetMaterial{dice.once(2) ? "white" : "no such"};
        case 9:
            return AddMaterial{dice.below(5)};
        case 10: {
            const EditAct act = kEditActs[dice.below(static_cast<std::uint32_t>(kEditActs.size()))].value;
            const bool many = thingsOf(state.scene->description).size() > 40;  // which copies would double
            return many && act == EditAct::copy ? Command(Undo{}) : Command(ActOnSelected{act});
        }
        case 11:
            return AddNew{kTools[dice.below(static_cast<std::uint32_t>(kTools.size()))].value, Vec2(0.0),
                          Vec2(dice.between(-1, 1), dice.between(-1, 1))};
        case 12:
            return ChooseSkyImage{dice.once(2) ? "" : "sky.png"};
        case 0:
            return SetEditing{!dice.once(4)};
        case 1:
            return SetTool{kTools[dice.below(static_cast<std::uint32_t>(kTools.size()))].value};
        case 2:
            return SelectThings{Thing{static_cast<ThingKind>(dice.below(3)), dice.below(6)}};
        case 3:
            return Undo{};
        case 4:
            return Redo{};
        default:
            return randomEdit(dice, state);
    }
}

InstrumentSettings randomInstruments(Dice& dice) {
    InstrumentSettings settings;
    settings.dial.scale = std::pow(10.0, dice.between(-8, 8));
    settings.dial.offset = dice.once(2) ? 0.0 : std::pow(10.0, dice.between(-2, 7));
    settings.dial.gap = dice.once(2) ? 0.0 : std::pow(10.0, dice.between(-9, 0));
    settings.dial.fixedEpsilon = std::pow(10.0, dice.between(-14, 2));
    settings.dial.precision = kPrecisions[dice.below(2)].value;
    settings.dial.policy = kEpsilonPolicies[dice.below(4)].value;
    settings.wish = kWishes[dice.below(2)].value;
    settings.wishedError = std::pow(10.0, dice.between(-5, 2));
    settings.wishedMilliseconds = dice.once(8) ? std::nan("") : std::pow(10.0, dice.between(-3, 6));
    settings.tolerance = std::pow(10.0, dice.between(-6, 1));
    for (std::uint32_t i = 0; i < dice.below(3); ++i)
        settings.forced.push_back(
            {kRequirements[dice.below(static_cast<std::uint32_t>(kRequirements.size()))].id, dice.below(4)});
    return settings;
}

Command randomCommand(Dice& dice, const AppState& state, const std::vector<std::filesystem::path>& files) {
    const auto walls = static_cast<std::uint32_t>(state.scene->scene.segments.size());
    switch (dice.below(43)) {
        case 39:
            return PinPixel{dice.once(4) ? std::nullopt : std::optional(dice.below(260))};
        case 41:
            return SetInstruments{randomInstruments(dice)};
        case 42:
            return PickTrade{dice.once(3) ? std::nullopt : std::optional<std::size_t>(dice.below(100)),
                             randomMaker(dice)};
        case 40:
            return SortSamples{dice.once(2)};
        case 20:
        case 21:
        case 22:
        case 23:
            return randomEditing(dice, state);
        case 24:
            return SetMakers{
                {randomMaker(dice), dice.once(2) ? std::optional(randomMaker(dice)) : std::nullopt}};
        case 25:
            return SetSplit{dice.between(-1, 2)};
        case 30:
            return SetRun{kRuns[dice.below(static_cast<std::uint32_t>(kRuns.size()))].value};
        case 31:
            return SetLanguage{dice.once(2) ? "de" : dice.once(2) ? "nowhere" : ""};
        case 32:
            return DrawCurve{dice.between(-1, 4), dice.between(-1, 4), dice.between(-1, 1e9f),
                             dice.between(0, 2)};
        case 33:
            return SetFieldScale{kFieldScales[dice.below(3)].value};
        case 34:
            return FilterSamples{std::pair<double, double>(dice.between(-1, 1), dice.between(-1, 1))};
        case 35:
            return JumpToSource{{"core/walk.h", static_cast<int>(dice.below(120))},
                                {"core/walk.h", static_cast<int>(dice.below(120))}};
        case 36:
            return dice.once(2) ? Command(ExportSeen{}) : Command(DismissNotice{});
        case 37:
            return ShowSample{dice.below(100'000)};
        case 38:
            return WeighStrategies{dice.once(2)};
        case 26:
            return ShowPalette{dice.once(2)};
        case 27:
            return SetQuery{dice.once(2) ? "se" : "\xff\u03b8 \xce"};
        case 28:
            return ShowFiles{dice.once(2)};
        case 29:
            return SelectEntry{dice.once(4) ? SIZE_MAX : dice.below(300)};
        case 0:
            return GoTo{"controls", dice.below(12)};
        case 1:
            return GoTo{dice.once(2) ? "field" : "nowhere", dice.below(3)};
        case 2:
            return OpenFile{files[dice.below(static_cast<std::uint32_t>(files.size()))]};
        case 3:
            return OpenScene{files[dice.below(static_cast<std::uint32_t>(files.size()))]};
        case 4:
            return Reload{};
        case 5:
        case 6:
            return SetSettings{randomSettings(dice)};
        case 7:
        case 8:
            return MovePoint{{dice.below(walls + 2), static_cast<double>(dice.between(-0.5f, 1.5f))}};
        case 9:
            return SetEvent{dice.once(4) ? SIZE_MAX : dice.below(500)};
        case 10:
            return StepEvents{static_cast<int>(dice.below(41)) - 20};
        case 11:
            return JumpToLine{static_cast<int>(dice.below(40))};
        case 12:
            return TogglePlay{};
        case 13:
            return FitCamera{};
        case 14:
            return SetView{kViews[dice.below(static_cast<std::uint32_t>(kViews.size()))].value, dice.once(2)};
        case 15:
            return UnlockAll{!dice.once(4)};
        case 16:
            return ToggleHelp{};
        case 17:
            return DismissBanner{};
        case 18:
            return NextStep{};
        default:
            return ResetStep{};
    }
}

/// A place on a widget that is on screen, or anywhere.
MouseMove randomPlace(Dice& dice, Rig& rig) {
    const auto& widgets = rig.session.widgets.widgets;
    if (!widgets.empty() && !dice.once(3)) {
        const Rect& target = widgets[dice.below(static_cast<std::uint32_t>(widgets.size()))].target;
        return {target.centerX(), target.centerY()};
    }
    if (dice.once(30)) return {-FLT_MAX, -FLT_MAX};  // the pointer left the window
    return {dice.between(-50, 2000), dice.between(-50, 1200)};
}

void act(Dice& dice, Rig& rig, const std::vector<std::filesystem::path>& files) {
    switch (dice.below(12)) {
        case 0:
        case 1:
        case 2:
            rig.host->queue(randomPlace(dice, rig));
            break;
        case 3:
        case 4:
        case 5:
            rig.host->queue(MouseButton{dice.once(5) ? static_cast<int>(dice.below(3)) : 0, !dice.once(2)});
            break;
        case 6:
            rig.host->queue(
                MouseWheel{dice.between(-6, 6) * (dice.once(20) ? 1e6f : 1.0f), dice.between(-1, 1)});
            break;
        case 7:
        case 8:
            rig.host->queue(KeyChange{static_cast<Key>(dice.below(static_cast<std::uint32_t>(Key::count))),
                                      !dice.once(2)});
            break;
        case 9: {
            constexpr char32_t kCharacters[] = U"0123456789.-e?nN \u03b8\U0001F600\uFFFF";
            rig.host->queue(
                Character{kCharacters[dice.below(static_cast<std::uint32_t>(std::size(kCharacters) - 1))]});
            break;
        }
        case 10:
            if (dice.once(10))
                rig.host->resize(960 + static_cast<int>(dice.below(900)),
                                 600 + static_cast<int>(dice.below(500)));
            if (dice.once(40)) apply(rig.session.state, SetUiScale{dice.between(0.2f, 5.0f)});
            break;
        default:
            halfdisk::apply(rig.session.state, randomCommand(dice, rig.state(), files));
    }
}

/// Letters of another size take a quarter of a second to make: most wishes for one are not granted.
void keepScale(Dice& dice, Rig& rig, float& scale) {
    if (rig.state().uiScale == scale) return;
    if (!dice.once(25)) rig.session.state.uiScale = scale;
    scale = rig.state().uiScale;
    rig.host->setUiScale(scale);
}

void checkWhole(const AppState& state) {
    REQUIRE(state.scene);
    const std::size_t walls = state.scene->scene.segments.size();
    REQUIRE(walls > 0);
    REQUIRE(state.at.segment < walls);
    REQUIRE((state.at.t >= 0.0 && state.at.t <= 1.0));
    REQUIRE((state.settings.samples >= 1 && state.settings.samples <= kMostLessonSamples));
    REQUIRE(state.settings.maxDepth <= kMostLessonDepth);
    REQUIRE((isFinite(state.camera.center) && std::isfinite(state.camera.pixelsPerMeter)));
    REQUIRE(state.camera.pixelsPerMeter > 0.0);
    REQUIRE((state.uiScale >= 0.5f && state.uiScale <= 6.0f));
    if (state.lesson) REQUIRE(state.step < state.lesson->steps.size());
    if (state.answer) REQUIRE(state.answer->asked.scene == state.scene);
}

void letGoOfEverything(Rig& rig) {
    for (int button = 0; button < 3; ++button) rig.host->queue(MouseButton{button, false});
    for (int key = 0; key < static_cast<int>(Key::count); ++key)
        rig.host->queue(KeyChange{static_cast<Key>(key), false});
    while (rig.host->hasQueuedInput()) rig.driver.frames();
    apply(rig.session.state, SetUiScale{1.0f});
    rig.host->resize(1280, 800);
    if (rig.state().helpShown) apply(rig.session.state, ToggleHelp{});
    rig.driver.frames(3);
    for (int i = 0; i < 3; ++i) rig.driver.pressKey(Key::escape);  // closes what is open
    apply(rig.session.state, DismissBanner{});
    rig.driver.frames(30);
}

void checkSurvives(std::uint32_t seed) {
    const LessonsCopy lessons;
    const Within folder(lessons.folder);
    const auto files = garbage(lessons.folder);
    Dice dice{std::mt19937(seed)};
    Rig rig(openLesson(lessons.folder, LessonRef{"controls", 1}));
    rig.session.state.editing.path =
        (lessons.folder / "saved.toml").string();  // Ctrl S comes by chance as well
    const int events = eventCount();
    float scale = rig.state().uiScale;
    for (int event = 0; event < events; ++event) {
        CAPTURE(event);
        act(dice, rig, files);
        rig.driver.frames();
        checkWhole(rig.state());
        keepScale(dice, rig, scale);
    }
    // It still does what it is told.
    letGoOfEverything(rig);
    rig.apply(GoTo{"controls", 1});
    rig.settle();
    CHECK(rig.state().lesson->slug == "controls");
    rig.driver.click("Lesson/Next");
    CHECK(rig.state().step == 2);
    rig.settle();
    CHECK(rig.state().answer->complete);
    CHECK(rig.state().answer->asked.settings == rig.state().settings);
}

/// Hands that change one scene, by keys, pointer and commands; then all is taken back.
void checkUndoes(std::uint32_t seed) {
    const LessonsCopy lessons;
    const Within folder(lessons.folder);
    Dice dice{std::mt19937(seed)};
    Rig rig(openScene(lessons.folder, lessons.folder / "scenes/box.toml"));
    rig.session.state.editing.path = (lessons.folder / "saved.toml").string();
    rig.apply(SetEditing{true});
    const SceneDescription first = rig.state().scene->description;
    constexpr int kChanges = 1500;
    constexpr std::size_t kMostThings = 30;
    for (int i = 0; i < kChanges; ++i) {
        CAPTURE(i);
        const bool many = thingsOf(rig.state().scene->description).size() > kMostThings;
        if (dice.once(2))
            rig.host->queue(randomPlace(dice, rig));
        else if (dice.once(2))
            rig.host->queue(MouseButton{0, !dice.once(2)});
        else if (many)
            apply(rig.session.state, Undo{});
        else
            halfdisk::apply(rig.session.state, randomEditing(dice, rig.state()));
        rig.driver.frames();
        checkWhole(rig.state());
        REQUIRE(faultOf(rig.state().scene->description).empty());
    }
    letGoOfEverything(rig);
    for (int i = 0; i < 10 * kChanges && !rig.state().editing.history.past.empty(); ++i)
        apply(rig.session.state, Undo{});
    CHECK(rig.state().scene->description == first);
    while (!rig.state().editing.history.future.empty()) apply(rig.session.state, Redo{});
    rig.driver.frames();
    rig.settle();
    CHECK(rig.state().answer->asked.scene == rig.state().scene);
}

}  // namespace

TEST_CASE("after random changes of a scene, undo returns to the first state") {
    checkUndoes(3);
}

// Four quarters of five thousand, which CTest runs side by side.
TEST_CASE("random events leave the program whole: the first quarter") {
    checkSurvives(1);
}

TEST_CASE("random events leave the program whole: the second quarter") {
    checkSurvives(2);
}

TEST_CASE("random events leave the program whole: the third quarter") {
    checkSurvives(4);
}

TEST_CASE("random events leave the program whole: the last quarter") {
    checkSurvives(5);
}
