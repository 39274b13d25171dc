// How is a scene changed on the canvas? What is under the pointer, what a drag does, and the handles of what
// is selected.
#include <algorithm>
#include <cmath>

#include "app/canvas.h"
#include "app/edit_commands.h"

namespace halfdisk {
namespace {

constexpr float kHandleReach = 10, kThingReach = 9, kSnapReach = 8, kLeastDrag = 3;  // design pixels

double metres(const Canvas& canvas, float design) {
    return canvas.px(design) / canvas.camera.pixelsPerMeter;
}

/// Lines some 40 pixels apart, at round numbers.
double gridOf(const Canvas& canvas) {
    const double wanted = metres(canvas, 24);
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= wanted) return factor * power;
    return 10.0 * power;
}

/// Turned about `from` to the nearest multiple of 15 degrees.
Vec2 atRoundAngle(Vec2 from, Vec2 to) {
    constexpr double kStep = kPi / 12;
    const Vec2 way = to - from;
    const double angle = std::round(std::atan2(way.y, way.x) / kStep) * kStep;
    return from +
           glm::dot(way, Vec2(std::cos(angle), std::sin(angle))) * Vec2(std::cos(angle), std::sin(angle));
}

Vec2 placeOf(const Canvas& canvas, Vec2 place, std::optional<Thing> except) {
    const AppState& state = canvas.ui.state;
    if (!state.editing.snap || ImGui::GetIO().KeyAlt) return place;
    const auto& scene = state.editing.start ? state.editing.start : state.scene;
    return snapped(scene->description, except, place, metres(canvas, kSnapReach), gridOf(canvas));
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
        if (editing.selected) handle = handleAt(canvas, *editing.selected, place);
        if (!handle) {
            const std::optional<Thing> under = thingAt(scene, place, metres(canvas, kThingReach));
            ui.commands.push_back(SelectThing{under});
            if (!under) {  // the canvas itself
                ui.commands.push_back(SetGrip{Grip::canvas});
                return;
            }
        }
    }
    const Vec2 from = editing.tool == Tool::select ? place : placeOf(canvas, place, std::nullopt);
    ui.commands.push_back(BeginGesture{from, handle});
    ui.commands.push_back(SetGrip{Grip::edit});
}

void continueEdit(const Canvas& canvas, Vec2 place) {
    const Ui& ui = canvas.ui;
    const Editing& editing = ui.state.editing;
    if (!editing.start) return;
    if (!editing.changing && glm::length(place - editing.grabbed) < metres(canvas, kLeastDrag)) return;
    SceneDescription scene = editing.start->description;
    std::optional<Thing> thing = editing.selected;
    const bool round = ImGui::GetIO().KeyShift;
    if (editing.tool != Tool::select) {
        Vec2 to = placeOf(canvas, place, std::nullopt);
        if (round) to = atRoundAngle(editing.grabbed, to);
        thing = addThing(scene, editing.tool, editing.grabbed, to);
    } else if (thing && exists(scene, *thing) && editing.handle) {
        const std::vector<Vec2> handles = handlesOf(scene, *thing);
        Vec2 to = placeOf(canvas, place, thing);
        if (round && handles.size() > 1) to = atRoundAngle(handles[*editing.handle == 0 ? 1 : 0], to);
        if (*editing.handle < handles.size()) pullHandle(scene, *thing, *editing.handle, to);
    } else if (thing && exists(scene, *thing)) {
        // One of its handles is brought to where things snap; the others follow.
        const std::vector<Vec2> handles = handlesOf(scene, *thing);
        Vec2 by = place - editing.grabbed;
        if (!handles.empty()) by = placeOf(canvas, handles.front() + by, thing) - handles.front();
        moveBy(scene, *thing, by);
    }
    if (thing) ui.commands.push_back(EditScene{std::move(scene), thing, editing.changing});
}

void drawEditing(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    const Editing& editing = state.editing;
    if (!editing.on || !editing.selected || !exists(state.scene->description, *editing.selected)) return;
    const Palette& palette = canvas.ui.palette;
    const SceneDescription& scene = state.scene->description;
    if (editing.selected->kind == ThingKind::shape)
        for (const Edge& edge : edgesOf(scene.shapes[editing.selected->index].geometry))
            canvas.line(edge.a, edge.b, withOpacity(palette.accent, 0.35f), canvas.px(10));
    const std::vector<Vec2> handles = handlesOf(scene, *editing.selected);
    constexpr std::size_t kMostDrawn = 500;
    for (std::size_t i = 0; i < std::min(handles.size(), kMostDrawn); ++i) {
        const ImVec2 at = canvas.screen(handles[i]);
        const float half = canvas.px(5);
        canvas.list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, palette.panel);
        canvas.list.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, palette.accent, 0.0f,
                            ImDrawFlags_None, canvas.px(2));
    }
}

}  // namespace halfdisk
