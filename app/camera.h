// Where on the screen is a point of the plane? World y points up, screen y down.
#pragma once

#include <imgui.h>

#include <optional>
#include <utility>

#include "app/prepared_scene.h"

namespace halfdisk {

/// What the canvas shows: the world point in its middle, and its magnification.
struct Camera {
    Vec2 center{0.0};
    double pixelsPerMeter = 100.0;
    bool operator==(const Camera&) const = default;
};

/// The canvas' rectangle on the screen, pixels.
struct CanvasRect {
    ImVec2 min, max;

    ImVec2 center() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
    float width() const { return max.x - min.x; }
    float height() const { return max.y - min.y; }
    bool contains(ImVec2 p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
};

/// Far points are drawn nearer on the same line from the canvas' middle: use `clipped` for what reaches that
/// far.
ImVec2 toScreen(const Camera& camera, const CanvasRect& canvas, Vec2 world);
Vec2 toWorld(const Camera& camera, const CanvasRect& canvas, ImVec2 screen);

/// The part of the line a-b (m) that lies within three canvas sizes of the canvas, on the screen. In double:
/// also right if both ends are light years away.
std::optional<std::pair<ImVec2, ImVec2>> clipped(const Camera& camera, const CanvasRect& canvas, Vec2 a,
                                                 Vec2 b);

/// The camera that shows all of `bounds` with a margin (pixels).
Camera fitted(const Bounds& bounds, const CanvasRect& canvas, float margin);

/// Magnified by `factor` so that the world point under `screen` stays there. Stays within 1e-6 ... 1e12
/// pixels per metre.
Camera zoomed(const Camera& camera, const CanvasRect& canvas, ImVec2 screen, double factor);

/// The least of 1, 2, 5, 10, 20, ... (m) that takes so many pixels or more.
double roundStep(const Camera& camera, double pixels);

/// Moved by a distance on the screen.
Camera panned(const Camera& camera, ImVec2 pixels);

}  // namespace halfdisk
