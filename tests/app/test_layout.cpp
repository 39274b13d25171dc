// Is every word of every lesson step readable, at the sizes of screens and letters that a class has?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rig.h"

using namespace halfdisk;

namespace {

struct Screen {
    int width, height;
    float scale;
};

constexpr Screen kScreens[] = {{960, 600, 1.0f},   {1280, 800, 1.0f},  {1280, 800, 1.5f},
                               {1280, 800, 2.0f},  {1920, 1080, 1.0f}, {1920, 1080, 1.5f},
                               {1920, 1080, 2.0f}, {1920, 1080, 3.0f}};

constexpr float kPixel = 1.0f;

bool isSeen(const Widget& widget) {
    return widget.target.width() > kPixel && widget.target.height() > kPixel;
}

/// Words, and things that words must not lie on. Areas hold other things; options lie over what is below
/// them.
bool isSolid(const Widget& widget) {
    return widget.kind != WidgetKind::area && widget.kind != WidgetKind::option && isSeen(widget);
}

/// What is inked of a visible line of words: without the leading above capitals, and below the baseline if no
/// letter descends. The shares are those of Inter.
Rect ink(const Widget& widget) {
    if (widget.kind != WidgetKind::text) return widget.target;
    const bool descends =
        widget.name.find_first_of("gjpqy(),;[]{}|", widget.window.size() + 1) != std::string::npos;
    const float line = widget.rect.height();
    Rect inked = widget.rect;
    inked.top += 0.2f * line;
    inked.bottom -= (descends ? 0.05f : 0.2f) * line;
    return intersection(inked, widget.target);
}

/// Whether the visible parts of both share more than a pixel both ways.
bool cover(const Widget& a, const Widget& b) {
    const Rect both = intersection(ink(a), ink(b));
    return both.width() > kPixel && both.height() > kPixel;
}

/// A widget that covers others on purpose.
bool isOverlay(const Widget& widget) {
    return widget.window == "Keys" || widget.window == "Message" || widget.window == "Commands" ||
           widget.window == "Files";
}

std::string place(const Widget& widget) {
    const Rect& r = widget.rect;
    return fmt::format("\"{}\" at {:.0f},{:.0f} {:.0f}x{:.0f}", widget.name, r.left, r.top, r.width(),
                       r.height());
}

/// What a reader can choose to see: a small screen shows one column or two, and a low one hides the canvas on
/// demand.
struct Arrangement {
    Pane pane;
    bool canvasHidden;
    std::string_view name;
};

constexpr Arrangement kArrangements[] = {{Pane::lesson, false, "lesson"},
                                         {Pane::stage, false, "stage"},
                                         {Pane::controls, false, "controls"},
                                         {Pane::stage, true, "stage, canvas hidden"}};

using Faults = std::vector<std::string>;

/// Words that are cut off, or lie on others.
void findUnreadable(const Session& session, const Screen& screen, Faults& found) {
    const auto width = static_cast<float>(screen.width);
    std::vector<const Widget*> solid;
    for (const Widget& widget : session.widgets.widgets)
        if (isSolid(widget)) solid.push_back(&widget);
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const Widget& widget = *solid[i];
        const bool cut =
            widget.rect.left < widget.target.left - kPixel ||
            (widget.rect.right > widget.target.right + kPixel && widget.kind == WidgetKind::text);
        if (cut) found.push_back("cut off at a side: " + place(widget));
        if (widget.target.right > width + kPixel || widget.target.left < -kPixel)
            found.push_back("off the screen: " + place(widget));
        for (std::size_t k = 0; k < i; ++k)
            if (isOverlay(widget) == isOverlay(*solid[k]) && cover(widget, *solid[k]))
                found.push_back(place(widget) + " lies on " + place(*solid[k]));
    }
}

/// What the arrangement is for must be there.
void findMissing(const Session& session, const Screen& screen, const Arrangement& arrangement,
                 Faults& found) {
    const auto width = static_cast<float>(screen.width), height = static_cast<float>(screen.height);
    const auto whole = [&](const char* name) {
        const Widget* widget = session.widgets.find(name);
        if (!widget || widget->target != widget->rect || widget->rect.bottom > height ||
            widget->rect.right > width)
            found.push_back(std::string(name) + " is not wholly in sight");
    };
    if (arrangement.pane == Pane::lesson) {
        whole("Lesson/Next");
        whole("Lesson/Previous");
    }
    if (arrangement.pane == Pane::controls && !session.widgets.find("Controls/N"))
        found.push_back("no controls");
    if (arrangement.pane != Pane::stage || arrangement.canvasHidden) return;
    const Widget* canvas = session.widgets.find("Stage/canvas");
    constexpr float kLeastShare = 0.25f, kLeastHeight = 100.0f;
    if (!canvas || canvas->target.width() < kLeastShare * width ||
        canvas->target.height() < kLeastHeight * screen.scale)
        found.push_back("the canvas is too small");
}

/// One host for each screen, since letters take long to draw.
std::vector<std::unique_ptr<HeadlessHost>> hosts() {
    std::vector<std::unique_ptr<HeadlessHost>> all;
    for (const Screen& screen : kScreens)
        all.push_back(HeadlessHost::withoutGl(screen.width, screen.height, screen.scale));
    return all;
}

void show(Session& session, HeadlessHost& host, const Screen& screen, const Arrangement& arrangement) {
    session.state.uiScale = screen.scale;
    session.state.pane = arrangement.pane;
    session.state.canvasHidden = arrangement.canvasHidden;
    session.state.fitCamera = true;
    for (int i = 0; i < 4; ++i)
        host.frameWithoutDrawing([&] { frame(session, host.fonts(), host.uiScale()); });
}

/// As `prepare` leaves it, on every screen that has a host.
void checkEverywhere(const std::vector<std::unique_ptr<HeadlessHost>>& screens, AppState opened,
                     const std::string& what, const std::function<void(AppState&)>& prepare = {}) {
    Session session;
    session.state = std::move(opened);
    session.effort = 1e-3;  // words and places are the same when only the first pictures are there
    askLight(session);
    session.light.waitUntilIdle();
    show(session, *screens[0], kScreens[0], kArrangements[0]);
    if (prepare) prepare(session.state);
    askLight(session);
    session.light.waitUntilIdle();
    for (std::size_t i = 0; i < std::size(kScreens); ++i)
        for (const Arrangement& arrangement : kArrangements) {
            if (!screens[i]) continue;
            const Screen& screen = kScreens[i];
            show(session, *screens[i], screen, arrangement);
            Faults found;
            findUnreadable(session, screen, found);
            findMissing(session, screen, arrangement, found);
            std::string listed;
            constexpr std::size_t kMostListed = 6;
            for (std::size_t k = 0; k < std::min(found.size(), kMostListed); ++k)
                listed += "\n    " + found[k];
            const std::string where =
                fmt::format("{} at {}x{}, scale {}, {}: {} faults", what, screen.width, screen.height,
                            screen.scale, arrangement.name, found.size());
            CHECK_MESSAGE(found.empty(), where, listed);
        }
}

}  // namespace

TEST_CASE("every step of every lesson is laid out without a fault") {
    const auto screens = hosts();
    for (const LessonEntry& entry : listLessons(courseLessons())) {
        REQUIRE_MESSAGE(entry.error.empty(), entry.error);
        for (int step = 1; step <= entry.steps; ++step)
            checkEverywhere(screens, openLesson(courseLessons(), LessonRef{entry.slug, step}),
                            fmt::format("{}:{}", entry.slug, step));
    }
}

TEST_CASE("in German, too, every step is laid out without a fault") {
    auto screens = hosts();
    // The smallest one, the usual one, and that with large letters: longer words tell there.
    for (std::size_t i = 0; i < screens.size(); ++i)
        if (i != 0 && i != 1 && i != 3) screens[i].reset();
    for (const LessonEntry& entry : listLessons(courseLessons()))
        for (int step = 1; step <= entry.steps; ++step) {
            AppState opened = openLesson(courseLessons(), LessonRef{entry.slug, step});
            apply(opened, SetLanguage{"de"});
            REQUIRE(opened.banner.empty());
            checkEverywhere(screens, std::move(opened), fmt::format("{}:{} in German", entry.slug, step));
        }
}

TEST_CASE("everything unlocked, all answers shown and every view on are laid out without a fault") {
    const auto screens = hosts();
    for (const LessonEntry& entry : listLessons(courseLessons()))
        checkEverywhere(screens, openLesson(courseLessons(), LessonRef{entry.slug, 1}),
                        entry.slug + ", all shown", [](AppState& state) {
                            apply(state, UnlockAll{true});
                            apply(state, RevealAnswer{});
                            for (const Named<View>& view : kViews) apply(state, SetView{view.value, true});
                            apply(state, SetEvent{7});
                        });
}

TEST_CASE("the help, a banner and a refused run are laid out without a fault") {
    const auto screens = hosts();
    const auto opened = [] { return openLesson(testLessons(), LessonRef{"controls", 8}); };
    checkEverywhere(screens, opened(), "help", [](AppState& state) { apply(state, ToggleHelp{}); });
    checkEverywhere(screens, opened(), "banner", [](AppState& state) {
        apply(state,
              OpenFile{"/a/folder with a rather long name/and another one inside/that is not there.toml"});
    });
    checkEverywhere(screens, opened(), "waiting", [](AppState& state) { apply(state, ExportSeen{}); });
    checkEverywhere(screens, opened(), "exported", [](AppState& state) {
        state.notice =
            "12 files are written to /a/folder with a rather long name/and another one/halfdisk-x-1";
    });
    checkEverywhere(screens, opened(), "commands", [](AppState& state) {
        apply(state, UnlockAll{true});
        apply(state, ShowPalette{true});
    });
    checkEverywhere(screens, opened(), "commands found", [](AppState& state) {
        apply(state, ShowPalette{true});
        apply(state, SetQuery{"a"});
    });
    checkEverywhere(screens, opened(), "no such command", [](AppState& state) {
        apply(state, ShowPalette{true});
        apply(state, SetQuery{std::string(300, 'q')});
    });
    checkEverywhere(screens, opened(), "files", [](AppState& state) {
        remember(state.recent,
                 "/a/folder with a rather long name/and another one inside/that is not there.toml");
        apply(state, ShowFiles{true});
        apply(state, OpenFile{"/a/folder with a rather long name/and another one/missing.toml"});
    });
    checkEverywhere(screens, opened(), "too many rays", [](AppState& state) {
        Settings settings = state.settings;
        settings.samples = 4096;
        settings.maxDepth = 8;
        apply(state, SetSettings{settings});
    });
}

TEST_CASE("a scene without a lesson is laid out without a fault") {
    const auto host = HeadlessHost::withoutGl(960, 600);
    Session session;
    session.state = openScene(testLessons(), testLessons() / "scenes/field.toml");
    askLight(session);
    session.light.waitUntilIdle();
    const Screen screen{960, 600, 1.0f};
    for (const Arrangement& arrangement : kArrangements) {
        show(session, *host, screen, arrangement);
        Faults found;
        findUnreadable(session, screen, found);
        for (const std::string& fault : found) CHECK_MESSAGE(false, fault);
    }
}

TEST_CASE("the panel for changing a scene is laid out without a fault") {
    const auto screens = hosts();
    const std::pair<const char*, std::function<void(AppState&)>> kinds[] = {
        {"the sky",
         [](AppState& state) {
             EditScene edit{state.scene->description, {}, false};
             edit.scene.environment.light = Environment(Rgb(1.0));
             edit.scene.environment.light.strip.assign(9, Rgb(0.25, 0.5, 1.0));
             apply(state, edit);
         }},
        {"one thing",
         [](AppState& state) {
             apply(state, SelectThings{Thing{ThingKind::shape, 0}});
         }},
        {"several",
         [](AppState& state) { apply(state, SelectThings{everything(state.scene->description)}); }}};
    for (const auto& kind : kinds) {
        Session session;
        session.state = openLesson(testLessons(), LessonRef{"controls", 1});
        apply(session.state, SetEditing{true});
        kind.second(session.state);
        askLight(session);
        session.light.waitUntilIdle();
        for (std::size_t i = 0; i < std::size(kScreens); ++i)
            for (const Arrangement& arrangement : kArrangements) {
                show(session, *screens[i], kScreens[i], arrangement);
                Faults found;
                findUnreadable(session, kScreens[i], found);
                for (const std::string& fault : found)
                    CHECK_MESSAGE(false, kind.first, " at ", kScreens[i].width, ", scale ", kScreens[i].scale,
                                  ": ", fault);
            }
    }
}

TEST_CASE("the help fits on every screen or scrolls: its last row and Close can be reached") {
    for (const Screen& screen : kScreens) {
        CAPTURE(screen.width);
        CAPTURE(screen.scale);
        AppState state = openLesson(testLessons(), LessonRef{"controls", 1});
        state.uiScale = screen.scale;
        Rig rig(std::move(state), screen.width, screen.height);
        rig.driver.frames(3);
        rig.driver.typeText("?");
        rig.driver.frames(3);
        rig.driver.moveTo(static_cast<float>(screen.width) / 2, static_cast<float>(screen.height) / 2);
        for (int notch = 0; notch < 40; ++notch) {
            rig.host->queue(MouseWheel{-1, 0});
            rig.driver.frames();
        }
        rig.driver.frames(2);
        rig.driver.click("Keys/Close");
        CHECK_FALSE(rig.state().helpShown);
    }
}

TEST_CASE("the faults that these tests look for are found") {
    Session session;
    const Screen screen{1000, 800, 1.0f};
    const auto add = [&](std::string name, WidgetKind kind, Rect rect, Rect target) {
        Widget widget;
        widget.name = std::move(name);
        widget.kind = kind;
        widget.rect = rect;
        widget.target = target;
        session.widgets.widgets.push_back(widget);
    };
    const auto addWhole = [&](std::string name, WidgetKind kind, Rect rect) {
        add(std::move(name), kind, rect, rect);
    };
    const auto faults = [&] {
        Faults found;
        findUnreadable(session, screen, found);
        for (const Arrangement& arrangement : kArrangements) findMissing(session, screen, arrangement, found);
        return found.size();
    };
    CHECK(faults() == 4);  // no navigation (two buttons), no controls, no canvas
    addWhole("Lesson/Next", WidgetKind::button, {0, 700, 50, 720});
    addWhole("Lesson/Previous", WidgetKind::button, {60, 700, 110, 720});
    addWhole("Stage/canvas", WidgetKind::area, {300, 0, 700, 400});
    addWhole("Controls/N", WidgetKind::number, {800, 10, 900, 30});
    addWhole("A/one", WidgetKind::text, {10, 10, 60, 30});
    CHECK(faults() == 0);
    addWhole("A/beside", WidgetKind::text, {59.5f, 10, 90, 30});
    CHECK(faults() == 0);
    addWhole("A/over", WidgetKind::text, {20, 20, 90, 40});
    CHECK(faults() == 2);
    session.widgets.widgets.pop_back();
    add("A/cut", WidgetKind::text, {100, 100, 200, 120}, {100, 100, 180, 120});
    CHECK(faults() == 1);
    session.widgets.widgets.pop_back();
    session.widgets.widgets[0].rect.bottom = 900;
    CHECK(faults() == 1);
}
