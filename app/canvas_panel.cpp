// How does the reader look around, and take hold of P? Pan, zoom to the pointer, fit, and drag P along the
// walls.
#include <cmath>

#include "app/canvas.h"
#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/key_help.h"
#include "app/key_words.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

Vec2 shadedNormal(const AppState& state) {
    return state.scene->index.normal(state.at.segment);
}

bool isOverSplit(const Canvas& canvas, ImVec2 mouse) {
    return hasSplit(canvas.ui.state) && std::abs(mouse.x - splitAt(canvas)) < canvas.px(8);
}

bool isOverPoint(const Canvas& canvas, ImVec2 mouse) {
    const ImVec2 p = canvas.screen(positionOf(canvas.ui.state.scene->scene, canvas.ui.state.at));
    return std::hypot(mouse.x - p.x, mouse.y - p.y) < canvas.px(16);
}

void interact(const Canvas& canvas, bool hovered, bool active) {
    const Ui& ui = canvas.ui;
    const ImGuiIO& io = ImGui::GetIO();
    const bool movable = ui.state.isUnlocked(Control::point);
    const bool overPoint = hovered && isOverPoint(canvas, io.MousePos);
    if (overPoint && ui.state.grip == Grip::none) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        tooltip(movable ? "P: drag it along the walls" : "P stays here in this step (Unlock all frees it)");
    }
    const bool overSplit = hovered && !overPoint && isOverSplit(canvas, io.MousePos);
    if (overSplit && ui.state.grip == Grip::none) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        tooltip("drag: more of A or more of B");
    }
    if (hovered && io.MouseWheel != 0.0f)
        ui.commands.push_back(
            SetCamera{zoomed(canvas.camera, canvas.rect, io.MousePos, std::pow(1.15, io.MouseWheel))});
    if (!active) {
        if (ui.state.grip == Grip::edit) endEdit(canvas);
        if (ui.state.grip != Grip::none) ui.commands.push_back(SetGrip{Grip::none});
        return;
    }
    const Vec2 place = toWorld(canvas.camera, canvas.rect, io.MousePos);
    if (ui.state.grip == Grip::none && ui.state.editing.on && ImGui::IsMouseDown(0) && !overPoint)
        return beginEdit(canvas, place);
    if (ui.state.grip == Grip::none) {
        const bool left = ImGui::IsMouseDown(0);
        ui.commands.push_back(SetGrip{left && overPoint && movable ? Grip::point
                                      : left && overSplit          ? Grip::split
                                                                   : Grip::canvas});
        return;
    }
    if (io.MouseDelta.x == 0.0f && io.MouseDelta.y == 0.0f) return;
    if (ui.state.grip == Grip::edit) continueEdit(canvas, place);
    if (ui.state.grip == Grip::band) continueBand(canvas, place);
    if (ui.state.grip == Grip::split)
        ui.commands.push_back(SetSplit{(io.MousePos.x - canvas.rect.min.x) / canvas.rect.width()});
    if (ui.state.grip == Grip::canvas) ui.commands.push_back(SetCamera{panned(canvas.camera, io.MouseDelta)});
    if (ui.state.grip == Grip::point)
        ui.commands.push_back(MovePoint{
            nearestWallPoint(ui.state.scene->scene, toWorld(canvas.camera, canvas.rect, io.MousePos))});
}

/// What the buttons in the canvas' upper right corner take side by side.
float cornerWidth(const AppState& state) {
    const float spacing = ImGui::GetStyle().ItemSpacing.x, padding = 2 * ImGui::GetStyle().FramePadding.x;
    float width = 0.0f;
    for (const char* label : {"Edit", "Fit", "Grid", "A-", "A+", "?"})
        if (!state.rules.kiosk || label != std::string_view("Edit"))
            width += textSize(label).x + padding + spacing;
    return width;
}

/// Small buttons in the canvas' upper right corner.
void cornerButtons(const Canvas& canvas) {
    const Ui& ui = canvas.ui;
    const float width = cornerWidth(ui.state);
    const float left = std::max(canvas.rect.min.x, canvas.rect.max.x - width - canvas.px(2));
    const ImVec2 corner{left, canvas.rect.min.y + canvas.px(6)};
    canvas.list.screen.AddRectFilled({corner.x - canvas.px(6), canvas.rect.min.y},
                                     {canvas.rect.max.x, corner.y + ImGui::GetFrameHeight() + canvas.px(6)},
                                     ui.palette.background);
    ImGui::SetCursorScreenPos(corner);
    if (!ui.state.rules.kiosk) {
        bool editing = ui.state.editing.on;
        if (toggle(ui.widgets, "Edit", editing)) ui.commands.push_back(SetEditing{editing});
        tooltip(
            withKey("change the scene: add, move and delete walls, lights and the eye", keyOf(KeyRow::edit)));
        sameLineIfFits("Fit");
    }
    if (button(ui.widgets, "Fit")) ui.commands.push_back(FitCamera{});
    tooltip(withKey("show the whole scene", keyOf(KeyRow::fit)));
    sameLineIfFits("Grid");
    bool grid = ui.state.shows(View::grid);
    if (toggle(ui.widgets, "Grid", grid)) ui.commands.push_back(SetView{View::grid, grid});
    tooltip(withKey("a grid behind the scene", keyOf(KeyRow::grid)));
    sameLineIfFits("A-");
    if (button(ui.widgets, "A-")) ui.commands.push_back(SetUiScale{ui.state.uiScale / 1.25f});
    tooltip(withKey("everything smaller", keyOf(KeyRow::size, 1)));
    sameLineIfFits("A+");
    if (button(ui.widgets, "A+")) ui.commands.push_back(SetUiScale{ui.state.uiScale * 1.25f});
    tooltip(withKey("everything larger, for the last row", keyOf(KeyRow::size)));
    sameLineIfFits("?");
    if (button(ui.widgets, "?")) ui.commands.push_back(ToggleHelp{});
    tooltip("keys (?)");
}

}  // namespace

float cornerHeight(const AppState& state, float width) {
    const int rows = 1 + static_cast<int>(cornerWidth(state) / std::max(width, 1.0f));
    return static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing();
}

void canvasPanel(const Ui& ui, ImVec2 size) {
    const AppState& state = ui.state;
    beginChild("canvas", size, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    const ImVec2 origin = ImGui::GetCursorScreenPos(), available = ImGui::GetContentRegionAvail();
    const CanvasRect rect{origin, {origin.x + available.x, origin.y + available.y}};
    const bool twoLegends = state.shows(View::field) && state.shows(View::rays);
    // P's letter stands behind its wall, which may be the uppermost one.
    const float letter = shadedNormal(state).y < 0.0 ? 26 * ui.scale : 0.0f;
    const float buttons =
                    std::min(cornerHeight(state, available.x) + 6 * ui.scale + letter, 0.4f * available.y),
                legend =
                    std::min((twoLegends ? 80 : 54) * ui.scale, (twoLegends ? 0.34f : 0.2f) * available.y);
    // With the frame defect the sampled half-disk reaches out behind the wall: it must be in sight too.
    const bool mirrored = state.settings.defects.has(Defect::frame);
    const float margin = std::min((mirrored ? 84 : 56) * ui.scale, (mirrored ? 0.2f : 0.12f) * available.x);
    const CanvasRect inner{{rect.min.x + margin, rect.min.y + buttons},
                           {rect.max.x - margin, rect.max.y - legend}};
    Camera camera = state.camera;
    if (state.fitCamera) {
        camera = fitted(state.scene->bounds, inner, std::min(14 * ui.scale, 0.05f * available.y));
        camera.center.y += (inner.center().y - rect.center().y) / camera.pixelsPerMeter;
        if (!(camera == state.camera)) ui.commands.push_back(SetCamera{camera, true});
    }
    OnSheet drawing(ui, "canvas", rect.min, rect.max);
    const Canvas canvas{ui, rect, camera, penOf(ui)};

    ImGui::SetItemAllowOverlap();
    ImGui::InvisibleButton("canvas", available,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight);
    ImGui::SetItemAllowOverlap();
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    mark(ui.widgets, "canvas", rect.min, rect.max);

    canvas.list.PushClipRect(rect.min, rect.max, true);
    const Vec2 P = positionOf(state.scene->scene, state.at), N = shadedNormal(state);
    drawField(canvas);
    drawWays(canvas);
    if (state.shows(View::grid)) drawGrid(canvas);
    if (state.shows(View::halfdisk)) drawHalfDisk(canvas, P, N, 1.0f);
    if (state.shows(View::tree)) drawTree(canvas);
    drawSamples(canvas);
    drawWalls(canvas);
    drawExtremes(canvas);
    drawRun(canvas);
    drawLights(canvas);
    drawEye(canvas);
    drawGaze(canvas);
    drawEditing(canvas);
    drawPoint(canvas, P, N);
    drawCurrentStep(canvas);
    drawTopic(canvas);
    drawShownSample(canvas);
    drawSplit(canvas);
    const ImVec2 p = canvas.screen(P);
    const ImVec2 below{p.x - canvas.px(20) * static_cast<float>(N.x),
                       p.y + canvas.px(20) * static_cast<float>(N.y)};
    if (fieldIsSeen(canvas))
        canvas.list.AddCircleFilled(below, 0.62f * ImGui::GetFontSize(),
                                    withOpacity(ui.palette.background, 0.9f));
    drawText(ui, {below.x, below.y - ImGui::GetFontSize() / 2}, ui.palette.estimate, "P", Align::middle,
             ui.fonts.strong);
    drawRayLegend(canvas);
    drawFieldLegend(canvas);
    canvas.list.PopClipRect();
    drawing.end();
    mark(ui.widgets, "P", {p.x - canvas.px(6), p.y - canvas.px(6)}, {p.x + canvas.px(6), p.y + canvas.px(6)});

    interact(canvas, hovered, active);
    cornerButtons(canvas);
    ImGui::EndChild();
}

}  // namespace halfdisk
