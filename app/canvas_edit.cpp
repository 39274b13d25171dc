// How is a scene changed on the canvas? What is under the pointer, what a drag does, and the handles of what
// is selected.
#include <algorithm>
#include <cmath>

#include "app/canvas.h"
#include "app/edit_commands.h"
#include "app/imgui_compat.h"
#include "lessons/shape_edges.h"

namespace halfdisk {
namespace {

constexpr float kHandleReach = 10, kThingReach = 9, kSnapReach = 8, kLeastDrag = 3;  // design pixels

double metres(const Canvas& canvas, float design) {
    return canvas.px(design) / canvas.camera.pixelsPerMeter;
}

/// Turned about `from` to the nearest multiple of 15 degrees.
Vec2 atRoundAngle(Vec2 from, Vec2 to) {
    constexpr double kStep = kPi / 12;
    const Vec2 way = to - from;
    const double angle = std::round(std::atan2(way.y, way.x) / kStep) * kStep;
    return from +
           glm::dot(way, Vec2(std::cos(angle), std::sin(angle))) * Vec2(std::cos(angle), std::sin(angle));
}

Vec2 placeOf(const Canvas& canvas, Vec2 place, const Selection& except) {
    const AppState& state = canvas.ui.state;
    if (!state.editing.snap || ImGui::GetIO().KeyAlt) return place;
    const auto& scene = state.editing.start ? state.editing.start : state.scene;
    return snapped(scene->description, except, place, metres(canvas, kSnapReach),
                   roundStep(canvas.camera, static_cast<double>(canvas.px(24))));
}

std::optional<std::size_t> handleAt(const Canvas& canvas, Thing thing, Vec2 place) {
    const std::vector<Vec2> handles = handlesOf(canvas.ui.state.scene->description, thing);
    std::optional<std::size_t> found;
    double nearest = metres(canvas, kHandleReach);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (glm::length(handles[i] - place) > nearest) continue;
        nearest = glm::length(handles[i] - place);
        found = i;
    }
    return found;
}

}  // namespace

void beginEdit(const Canvas& canvas, Vec2 place) {
    const Ui& ui = canvas.ui;
    const Editing& editing = ui.state.editing;
    const SceneDescription& scene = ui.state.scene->description;
    std::optional<std::size_t> handle;
    if (editing.tool == Tool::select) {
        // Handles are those of one thing.
        if (const auto one = editing.selected.single()) handle = handleAt(canvas, *one, place);
        if (!handle) {
            const std::optional<Thing> under = thingAt(scene, place, metres(canvas, kThingReach));
            const bool more = ImGui::GetIO().KeyShift;
            Selection selected = editing.selected;
            if (more && under)
                selected.toggle(*under);
            else if (under && selected.has(*under))
                selected.add(*under);  // which becomes the primary one: all of them can be dragged by it
            else if (!more)
                selected = under;
            ui.commands.push_back(SelectThings{selected});
            if (!under) {  // the canvas itself
                ui.commands.push_back(BeginGesture{place, std::nullopt});
                ui.commands.push_back(SetGrip{more ? Grip::band : Grip::canvas});
                return;
            }
        }
    }
    const Vec2 from = editing.tool == Tool::select ? place : placeOf(canvas, place, {});
    ui.commands.push_back(BeginGesture{from, handle});
    ui.commands.push_back(SetGrip{Grip::edit});
}

void endEdit(const Canvas& canvas) {
    const Ui& ui = canvas.ui;
    const Editing& editing = ui.state.editing;
    if (!editing.start || editing.changing || editing.tool != Tool::select) return;
    const std::optional<Thing> one = editing.selected.primary();
    if (!one) return;
    if (ImGui::GetIO().KeyShift) {
        // A bulb lies under its own handle.
        if (editing.handle) ui.commands.push_back(SelectThings{});
    } else if (editing.before == editing.selected) {
        ui.commands.push_back(SelectThings{*one});  // of several, the one that was clicked
    }
}

void continueBand(const Canvas& canvas, Vec2 place) {
    const Editing& editing = canvas.ui.state.editing;
    Selection selected = editing.before;
    for (const Thing thing : within(canvas.ui.state.scene->description, editing.grabbed, place).things)
        if (!editing.before.has(thing)) selected.things.push_back(thing);
    canvas.ui.commands.push_back(SelectThings{selected});
}

void continueEdit(const Canvas& canvas, Vec2 place) {
    const Ui& ui = canvas.ui;
    const Editing& editing = ui.state.editing;
    if (!editing.start) return;
    if (!editing.changing && glm::length(place - editing.grabbed) < metres(canvas, kLeastDrag)) return;
    SceneDescription scene = editing.start->description;
    Selection things = editing.selected;
    if (editing.tool == Tool::select && existing(scene, things).size() != things.size()) return;
    const bool round = ImGui::GetIO().KeyShift;
    if (editing.tool != Tool::select) {
        Vec2 to = placeOf(canvas, place, {});
        if (round) to = atRoundAngle(editing.grabbed, to);
        things = addThing(scene, editing.tool, editing.grabbed, to);
    } else if (things.empty()) {
        return;
    } else if (const auto one = things.single(); one && editing.handle) {
        const std::vector<Vec2> handles = handlesOf(scene, *one);
        Vec2 to = placeOf(canvas, place, things);
        if (round && handles.size() > 1) to = atRoundAngle(handles[*editing.handle == 0 ? 1 : 0], to);
        if (*editing.handle < handles.size()) pullHandle(scene, *one, *editing.handle, to);
    } else {
        // A handle of the one that is held is brought to where things snap; all else follows.
        const std::vector<Vec2> handles = handlesOf(scene, *things.primary());
        Vec2 by = place - editing.grabbed;
        if (!handles.empty()) by = placeOf(canvas, handles.front() + by, things) - handles.front();
        moveBy(scene, things, by);
    }
    ui.commands.push_back(EditScene{std::move(scene), things, editing.changing});
}

namespace {

/// Behind a shape that is selected; around a light or the eye among several.
void drawSelected(const Canvas& canvas, Thing thing, float opacity) {
    const SceneDescription& scene = canvas.ui.state.scene->description;
    const ImU32 color = withOpacity(canvas.ui.palette.accent, opacity);
    if (thing.kind == ThingKind::shape) {
        for (const Edge& edge : edgesOf(scene.shapes[thing.index].geometry))
            canvas.line(edge.a, edge.b, color, canvas.px(14));
        return;
    }
    const std::vector<Vec2> handles = handlesOf(scene, thing);
    if (!handles.empty())
        canvas.list.AddCircle(canvas.screen(handles.front()), canvas.px(13), color, 0, canvas.px(5));
}

void drawHandles(const Canvas& canvas, Thing thing) {
    const Palette& palette = canvas.ui.palette;
    const std::vector<Vec2> handles = handlesOf(canvas.ui.state.scene->description, thing);
    constexpr std::size_t kMostDrawn = 500;
    for (std::size_t i = 0; i < std::min(handles.size(), kMostDrawn); ++i) {
        const ImVec2 at = canvas.screen(handles[i]);
        const float half = canvas.px(5);
        canvas.list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, palette.panel);
        canvas.list.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, palette.accent, 0.0f,
                            ImDrawFlags_None, canvas.px(2));
    }
}

void drawBand(const Canvas& canvas) {
    const ImVec2 a = canvas.screen(canvas.ui.state.editing.grabbed), b = ImGui::GetIO().MousePos;
    const ImVec2 min{std::min(a.x, b.x), std::min(a.y, b.y)}, max{std::max(a.x, b.x), std::max(a.y, b.y)};
    canvas.list.AddRectFilled(min, max, withOpacity(canvas.ui.palette.accent, 0.12f));
    addRect(canvas.list, min, max, canvas.ui.palette.accent, 0.0f, canvas.px(2));
}

}  // namespace

void drawEditing(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    const Editing& editing = state.editing;
    if (!editing.on) return;
    const Selection selected = existing(state.scene->description, editing.selected);
    for (const Thing thing : selected.things)
        drawSelected(canvas, thing, thing == selected.primary() ? 0.5f : 0.32f);
    if (const auto one = selected.single()) drawHandles(canvas, *one);
    if (state.grip == Grip::band) drawBand(canvas);
}

}  // namespace halfdisk
