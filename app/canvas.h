// What does the canvas draw? Layers, from the back to the front; each reads the state and adds to the
// window's draw list.
#pragma once

#include "app/camera.h"
#include "app/pen.h"

namespace halfdisk {

/// The canvas while it is being drawn.
struct Canvas {
    const Ui& ui;
    CanvasRect rect;
    Camera camera;
    Pen list;

    ImVec2 screen(Vec2 world) const { return toScreen(camera, rect, world); }
    /// A line between two points of the plane, however far they are.
    void line(Vec2 a, Vec2 b, ImU32 color, float thickness) const;
    float px(float design) const { return design * ui.scale; }
    /// Where a ray from `from` along `direction` is clearly off the canvas.
    Vec2 farAlong(Vec2 from, Vec2 direction) const;
};

void drawGrid(const Canvas& canvas);
void drawField(const Canvas& canvas);
bool fieldIsSeen(const Canvas& canvas);
void drawWays(const Canvas& canvas);
void drawCloud(const Canvas& canvas, const std::shared_ptr<const RayCloud>& cloud);
/// So near that a cloud's picture is blurred: lines belong on top of it.
bool isBlurred(const Canvas& canvas, const RayCloud& cloud);

/// A button goes down at a place (m) while the scene is being changed; then it moves.
void beginEdit(const Canvas& canvas, Vec2 place);
void continueEdit(const Canvas& canvas, Vec2 place);
/// The rectangle from where the button went down; what lies in it is selected as well.
void continueBand(const Canvas& canvas, Vec2 place);
/// The button goes up.
void endEdit(const Canvas& canvas);
/// What is selected, and its handles.
void drawEditing(const Canvas& canvas);

void drawSplit(const Canvas& canvas);
/// Two fields side by side, the second right of a line that can be dragged.
bool hasSplit(const AppState& state);
float splitAt(const Canvas& canvas);  ///< pixels
void drawWalls(const Canvas& canvas);
/// What the dial of extremes does to the scene.
void drawExtremes(const Canvas& canvas);
void drawEye(const Canvas& canvas);
void drawLights(const Canvas& canvas);
void drawHalfDisk(const Canvas& canvas, Vec2 P, Vec2 N, float opacity);
void drawSamples(const Canvas& canvas);
void drawTree(const Canvas& canvas);
/// In place of castRay's samples and tree: the run of another estimator.
void drawRun(const Canvas& canvas);
void drawCurrentStep(const Canvas& canvas);
void drawPoint(const Canvas& canvas, Vec2 P, Vec2 N);
void drawGaze(const Canvas& canvas);
/// What the term that is looked up speaks of.
void drawTopic(const Canvas& canvas);
/// The one of the list that is under the pointer.
void drawShownSample(const Canvas& canvas);
void drawRayLegend(const Canvas& canvas);
void drawFieldLegend(const Canvas& canvas);

/// Of the buttons in the upper right corner of a canvas of this width, pixels.
float cornerHeight(const AppState& state, float width);

/// Top of a legend's words, pixels; row 0 is the lowest.
float legendRow(const Canvas& canvas, int row);

/// Radius of the half-disk on the screen, pixels.
float halfDiskRadius(const Canvas& canvas);

/// Point of a wall nearest to `world`; the scene has walls.
WallPoint nearestWallPoint(const Scene& scene, Vec2 world);

}  // namespace halfdisk
