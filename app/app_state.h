// What does the program remember between frames? Plain data: nothing lives in widgets or statics.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/camera.h"
#include "app/class_rules.h"
#include "app/editing.h"
#include "app/file_chooser.h"
#include "app/light_answer.h"
#include "lessons/lesson_list.h"

namespace halfdisk {

/// Where the reader stands in the recorded run.
struct Playback {
    bool stepping = false;  ///< show the run up to `event` only; else the whole of it
    std::size_t event = 0;  ///< events passed, 0 ... all
    bool playing = false;
    float sinceLast = 0.0f;  ///< s of frame time
    bool operator==(const Playback&) const = default;
};

/// Steps a second.
enum class PlaySpeed : std::uint8_t { slow, calm, usual, brisk, fast, racing };

inline constexpr std::array<Named<PlaySpeed>, 6> kPlaySpeeds{{
    {PlaySpeed::slow, "1 / s", "one step a second"},
    {PlaySpeed::calm, "2 / s", "two steps a second"},
    {PlaySpeed::usual, "4 / s", "four steps a second"},
    {PlaySpeed::brisk, "15 / s", "fifteen steps a second"},
    {PlaySpeed::fast, "60 / s", "sixty steps a second"},
    {PlaySpeed::racing, "500 / s", "five hundred steps a second"},
}};
inline constexpr std::array<float, kPlaySpeeds.size()> kStepsPerSecond{1, 2, 4, 15, 60, 500};

/// What the pointer holds on the canvas.
enum class Grip : std::uint8_t { none, point, canvas, split, edit, band };

/// Which column a small screen shows; a large one shows all three.
enum class Pane : std::uint8_t { lesson, stage, controls };

/// The list of all that can be done, while it is open.
struct PaletteState {
    bool shown = false;
    std::string query;
    std::size_t selected = 0;  ///< of those that the query finds
};

struct AppState {
    // the library
    std::filesystem::path lessonsFolder;
    std::vector<LessonEntry> lessons;
    std::optional<Lesson> lesson;         ///< none: a scene by itself
    std::size_t step = 0;                 ///< index into lesson->steps
    std::filesystem::path sceneOverride;  ///< a scene file shown instead of the lesson's; empty: none

    // what is looked at
    std::shared_ptr<const PreparedScene> scene;
    Settings settings;
    WallPoint at;
    Playback playback;
    PlaySpeed speed = PlaySpeed::usual;
    Run run = Run::castRay;                    ///< that is stepped through; see shownRun
    std::optional<std::uint32_t> pinnedPixel;  ///< of the eye's strip: the run is about it, not about P
    Side pinnedSide = Side::first;  ///< whose strip it is of: the second one's only if there is one
    FieldScale scale = FieldScale::light;
    std::optional<std::size_t> shownSample;                ///< of the list, under the pointer: its step
    std::optional<std::pair<double, double>> sampleRange;  ///< W/m: the list shows only what adds so much
    bool largestFirst = false;                             ///< the list, instead of as they came
    ViewSet show;
    bool strategiesAlone = false;  ///< each strategy (s, t) counts whole; else by its weight
    Makers makers;                 ///< of the pictures
    InstrumentSettings instruments;
    std::optional<std::size_t> pickedTrade;  ///< of the trade's settings: the one that the stage shows
    std::optional<Maker> beforePick;         ///< what made the pictures before it was picked
    bool unlockAll = false;
    ClassRules rules;

    Editing editing;

    // the screen
    Camera camera;
    bool fitCamera = true;  ///< keep the whole scene in sight; until the reader pans or zooms
    Grip grip = Grip::none;
    std::optional<std::uint32_t> eyePixel;  ///< of the eye's strip, under the pointer
    float split = 0.5f;  ///< of two fields side by side: where the second begins, 0 ... 1 of the canvas
    Pane pane = Pane::lesson;
    bool canvasHidden = false;  ///< on a low screen: the code or plot takes the canvas' place
    bool answerShown = false;
    bool helpShown = false;
    PaletteState palette;
    FileChooser files;
    std::vector<std::filesystem::path> recent;  ///< opened or saved, the last one first
    float uiScale = 1.0f;
    std::string language;       ///< of the window and the lessons; empty: English
    std::string toClipboard;    ///< until the frame has put it there
    std::string banner;         ///< a message about something that went wrong; the last good state stays
    std::string notice;         ///< a message about something that was done
    bool exportWished = false;  ///< what is seen is to be written to files as soon as its light is complete
    int chosenLine = 0;         ///< of the listing, by a click; 0: none
    std::vector<float> drawn;   ///< W/(m rad): the curve that the reader expects, by bins of theta from 0 to
                                ///< pi; negative: not drawn there. Empty: nothing yet
    bool drawing = false;       ///< the pointer is down on it
    Topic topic = Topic::none;  ///< of the term that is being looked up
    int litLine = 0;  ///< of the code panel: the line of the listing that it last scrolled to; 0: none yet

    // the light
    std::uint64_t questionId = 0;  ///< grows whenever scene, P, settings or wanted pictures change
    std::shared_ptr<const LightAnswer> answer;

    const Step* currentStep() const { return lesson ? &lesson->steps[step] : nullptr; }
    bool isUnlocked(Control control) const {
        const Step* current = currentStep();
        if (rules.isLocked(control)) return false;
        return unlockAll || !current || current->unlock == control;
    }
    bool shows(View view) const { return show.has(view); }
    /// The picture that the estimators' numbers are about: the largest one that is shown.
    std::optional<View> mainPicture() const {
        for (const View view : {View::field, View::eye, View::profile})
            if (shows(view)) return view;
        return std::nullopt;
    }
    /// Whose pixel is pinned; none: the usual one's.
    const std::optional<Maker>& pinnedMaker() const {
        return pinnedSide == Side::second ? makers.second : makers.first;
    }
    /// castRay gathers over half-disks, which an eye has not: a pixel's run is then that of the estimator
    /// which makes the strip, or of path if that one is not recorded.
    Run shownRun() const {
        if (!pinnedPixel || run != Run::castRay) return run;
        const std::optional<Maker>& maker = pinnedMaker();
        const auto made = maker ? valueOf(kRuns, std::string_view(maker->estimator)) : std::nullopt;
        return made && *made != Run::castRay ? *made : Run::path;
    }
    /// Of the run that is stepped through.
    std::size_t eventCount() const {
        if (answer && answer->pathRun) return answer->pathRun->record.events.size();
        return answer && answer->record ? answer->record->events.size() : 0;
    }
};

/// Into state.lessons, which are not none: after the last one comes the first.
inline std::size_t nextLessonIndex(const AppState& state) {
    for (std::size_t i = 0; i < state.lessons.size(); ++i)
        if (state.lesson && state.lessons[i].slug == state.lesson->slug)
            return (i + 1) % state.lessons.size();
    return 0;
}

}  // namespace halfdisk
