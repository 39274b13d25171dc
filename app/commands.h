// What can be done? Panels return commands; they are applied between frames, and tests can apply them too.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/app_state.h"

namespace halfdisk {

struct GoTo {
    std::string lesson;  ///< slug or number
    std::size_t step = 0;
};
struct NextStep {};
struct PreviousStep {};
struct ResetStep {};
struct OpenScene {
    std::filesystem::path file;
};
struct OpenFile {
    std::filesystem::path file;  ///< a lesson or a scene, told apart by what is in it
};
struct OpenShared {
    std::string text;  ///< see share_text.h
};
struct CopyState {};  ///< to the clipboard, see share_text.h
struct Reload {};     ///< read the files again; the step stays
struct SetSettings {
    Settings settings;
};
struct SetRun {
    Run run;
};
struct SetInstruments {
    InstrumentSettings settings;
};
struct PickTrade {
    std::optional<std::size_t> cell;  ///< the stage shows this setting; none: what it showed before
    Maker maker{};
};
struct SetFieldScale {
    FieldScale scale;
};
struct ShowSample {
    std::optional<std::size_t> event;  ///< step of the run; for the next frame only
};
struct FilterSamples {
    std::optional<std::pair<double, double>> range;  ///< W/m, of the contribution; none: all
};
struct SortSamples {
    bool largestFirst;
};
struct SetMakers {
    Makers makers;
};
struct WeighStrategies {
    bool alone;  ///< each counts whole
};
struct SetSplit {
    float split;
};
struct SetEditing {
    bool on;
};
struct SetTool {
    Tool tool;
};
struct SetSnap {
    bool on;
};
struct SelectThings {
    Selection things;
};
struct ActOnSelected {
    EditAct act;
};
/// A thing of a tool, as if it were drawn from one place to the other (m).
struct AddNew {
    Tool tool;
    Vec2 from, to;
};
struct MoveSelected {
    Vec2 by;         ///< m
    bool continues;  ///< the same gesture, if it still goes on
};
/// Of the selected shapes.
struct SetMaterial {
    std::string name;  ///< empty: the default one
};
struct AddMaterial {
    std::size_t kind;  ///< an alternative of Material
};
struct ChooseSkyImage {
    std::string image;  ///< beside the scene's file; empty: none
};
struct BeginGesture {
    Vec2 place;                         ///< m
    std::optional<std::size_t> handle;  ///< of the selected thing
};
struct EditScene {
    SceneDescription scene;
    Selection selected;
    bool continues = false;  ///< the same gesture: undone together with what came before
};
struct Undo {};
struct Redo {};
struct SetScenePath {
    std::string path;
};
struct SaveScene {
    std::string path;
};
struct MovePoint {
    WallPoint at;
};
struct SetEvent {
    std::size_t event;
};
struct StepEvents {
    int by;  ///< +1: the next event, -1: the one before
};
struct JumpToLine {
    int line;  ///< of the published listing: forward to the next event there, round the end
};
struct JumpToSource {
    SourceLine from, to;  ///< the same for an estimator's own source: lines from ... to - 1 of one file
};
struct SetSpeed {
    PlaySpeed speed;
};
struct ShowWholeRun {};
struct TogglePlay {};
struct SetCamera {
    Camera camera;
    bool fitted = false;  ///< the panel's own, to keep all in sight; else the reader's
};
struct FitCamera {};
struct ScrolledTo {
    int line;  ///< of the listing that is shown, counted from 1
};
struct SetGrip {
    Grip grip;
};
struct SetUiScale {
    float scale;
};
struct SetView {
    View view;
    bool on;
};
struct LookAlong {
    std::optional<std::uint32_t> pixel;  ///< of the eye's strip
};
struct PinPixel {
    std::optional<std::uint32_t> pixel;  ///< of the eye's strip: the run becomes its own; none: back to P
    Side side = Side::first;             ///< whose strip, where two are compared
};
struct ShowPane {
    Pane pane;
};
struct HideCanvas {
    bool hidden;
};
struct RevealAnswer {};
struct UnlockAll {
    bool on;
};
struct DrawCurve {
    double fromTheta, toTheta;  ///< rad: the stroke of this frame
    double from, to;            ///< W/(m rad), at its ends
};
struct EndStroke {};
struct LightTopic {
    Topic topic;  ///< in the next frame only
};
struct SetLanguage {
    std::string code;  ///< empty: English
};
struct ToggleHelp {};
struct ShowPalette {
    bool shown;
};
struct SetQuery {
    std::string query;
};
struct SelectEntry {
    std::size_t index;  ///< of those that the query finds
};
struct ShowFiles {
    bool shown;
};
struct SetFilePath {
    std::string path;
};
struct SelectFile {
    std::size_t index;
};
struct DismissBanner {};
struct ExportSeen {};     ///< to files, once the light is complete
struct DismissNotice {};  ///< and no export any more

using AnyCommand = std::variant<
    GoTo, NextStep, PreviousStep, ResetStep, OpenScene, OpenFile, OpenShared, CopyState, Reload, SetSettings,
    SetRun, SetFieldScale, SetInstruments, PickTrade, ShowSample, FilterSamples, SortSamples, SetMakers,
    WeighStrategies, SetSplit, SetEditing, SetTool, SetSnap, SelectThings, ActOnSelected, AddNew,
    MoveSelected, SetMaterial, AddMaterial, ChooseSkyImage, BeginGesture, EditScene, Undo, Redo, SetScenePath,
    SaveScene, MovePoint, SetEvent, StepEvents, JumpToLine, JumpToSource, ShowWholeRun, SetSpeed, TogglePlay,
    SetCamera, FitCamera, ScrolledTo, SetGrip, SetUiScale, SetView, LookAlong, PinPixel, ShowPane, HideCanvas,
    RevealAnswer, UnlockAll, DrawCurve, EndStroke, LightTopic, SetLanguage, ToggleHelp, ShowPalette, SetQuery,
    SelectEntry, ShowFiles, SetFilePath, SelectFile, DismissBanner, ExportSeen, DismissNotice>;
/// Its special members are compiled once, in commands.cpp: instantiated in every panel they were a third of
/// the build's time.
struct Command : AnyCommand {
    using AnyCommand::AnyCommand;
    Command(const Command& other);
    Command(Command&& other) noexcept;
    Command& operator=(const Command& other);
    Command& operator=(Command&& other) noexcept;
    ~Command();
};
using Commands = std::vector<Command>;

/// Whether the eye's strip is shown and has such a pixel.
bool canPin(const AppState& state, std::uint32_t pixel);

/// What a class may not do on a machine that stands for all: it does nothing.
bool isForbidden(const AppState& state, const Command& command);

/// Never throws for bad files: the message goes to state.banner and the rest of the state stays as it was.
void apply(AppState& state, const Command& command);

/// A lesson at a step; without `ref` the first one that can be read. `scene`, if not empty, replaces the
/// lesson's own. Throws InputError.
AppState openLesson(const std::filesystem::path& lessonsFolder, const std::optional<LessonRef>& ref,
                    const std::filesystem::path& scene = {});

/// The same for a scene that no file holds.
AppState openDescribed(const std::filesystem::path& lessonsFolder, const SceneDescription& scene);

/// From now on. The step that is open begins anew; else (what somebody shared) only what the rules say is
/// changed.
void setRules(AppState& state, const ClassRules& rules, bool asTheStepBegins = true);

/// A scene without a lesson: everything is unlocked. Throws InputError.
AppState openScene(const std::filesystem::path& lessonsFolder, const std::filesystem::path& scene);

}  // namespace halfdisk
