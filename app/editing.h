// What does the program remember of a scene that is changed by hand? Plain data, as all of its state.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/prepared_scene.h"
#include "lessons/selection.h"

namespace halfdisk {

/// What the pointer does on the canvas.
enum class Tool : std::uint8_t { select, wall, box, circle, lens, lamp, bulb, sun, eye };

inline constexpr std::array<Named<Tool>, 9> kTools{{
    {Tool::select, "Select",
     "click a thing; drag it, or one of its handles; Shift: several, also by a rectangle"},
    {Tool::wall, "Wall", "drag from end to end; its front is on the left"},
    {Tool::box, "Box", "drag from corner to corner"},
    {Tool::circle, "Circle", "drag from the middle to the rim"},
    {Tool::lens, "Lens", "drag from the middle along its axis; give it a glass as material"},
    {Tool::lamp, "Lamp", "drag from end to end: a wall that shines from its front, on the left"},
    {Tool::bulb, "Bulb", "drag a point light to its place"},
    {Tool::sun, "Sun", "drag along the way of the light"},
    {Tool::eye, "Eye", "drag from the eye to what it looks at; there is one"},
}};

/// What can be done to what is selected.
enum class EditAct : std::uint8_t { copy, remove, turn, larger, smaller, flip };

inline constexpr std::array<Named<EditAct>, 6> kEditActs{{
    {EditAct::copy, "Copy", "once more, beside it (Ctrl D)"},
    {EditAct::remove, "Delete", "take it away (Delete)"},
    {EditAct::turn, "Turn", "by 15 degrees; several about their common middle"},
    {EditAct::larger, "Larger", "by a tenth"},
    {EditAct::smaller, "Smaller", "by as much"},
    {EditAct::flip, "Flip", "front and back change places"},
}};

/// Whether it changes anything about these.
bool serves(EditAct act, const Selection& things);

/// Does it; returns what is selected then.
Selection perform(EditAct act, SceneDescription& scene, const Selection& things);

/// Scenes as they were. Old ones are forgotten when all together take more than kUndoBytes.
struct History {
    std::vector<std::shared_ptr<const PreparedScene>> past, future;  ///< the nearest last
};
inline constexpr std::size_t kUndoBytes = std::size_t{64} << 20;

/// About what a scene takes in memory.
std::size_t bytesOf(const PreparedScene& scene);

struct Editing {
    bool on = false;
    Tool tool = Tool::select;
    bool snap = true;  ///< to ends of things and to a grid
    Selection selected;
    History history;
    std::shared_ptr<const PreparedScene> clean;  ///< as it was opened or saved; null: as it is
    bool neverSaved = false;                     ///< it came from no file: a text that somebody sent
    std::shared_ptr<const PreparedScene>
        aside;               ///< unsaved changes that another scene has taken the place of
    std::string path;        ///< where it will be saved
    std::string origin;      ///< the scene that `path` was made up for
    std::string savedAs;     ///< the file that this program wrote last
    std::string message;     ///< about the last change or saving
    bool confirmed = false;  ///< that a file may be written over

    // while a button is held
    std::shared_ptr<const PreparedScene> start;  ///< as it was when the gesture began
    Vec2 grabbed{0.0};                           ///< where that was, m
    std::optional<std::size_t> handle;           ///< which is pulled
    Selection before;                            ///< what was selected then
    bool changing = false;                       ///< the gesture has changed something already
};

/// The material that a new thing gets: the file's first one; empty: the default.
std::string usualMaterial(const SceneDescription& scene);

/// A scene with a new thing of this tool, from one place to another. Nothing for Tool::select.
std::optional<Thing> addThing(SceneDescription& scene, Tool tool, Vec2 from, Vec2 to);

/// A place near `place` (m) that is an end of a thing not among `except`, or on the grid; `reach` (m): how
/// far.
Vec2 snapped(const SceneDescription& scene, const Selection& except, Vec2 place, double reach, double grid);

}  // namespace halfdisk
