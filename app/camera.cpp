#include "app/camera.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

// ImGui's coordinates are floats; what lies further out than this is off the screen anyway.
constexpr double kFarPixels = 1e6;

/// Cuts the parameters [from, to] of the points p + s d to those with p + s d <= most.
void cut(double p, double d, double most, double& from, double& to) {
    const double s = (most - p) / d;
    if (d > 0.0)
        to = std::min(to, s);
    else if (d < 0.0)
        from = std::max(from, s);
    else if (p > most)
        to = -1.0;
}

}  // namespace

ImVec2 toScreen(const Camera& camera, const CanvasRect& canvas, Vec2 world) {
    const ImVec2 middle = canvas.center();
    Vec2 offset = (world - camera.center) * camera.pixelsPerMeter;
    const double far = std::max(std::abs(offset.x), std::abs(offset.y));
    if (far > kFarPixels) offset *= kFarPixels / far;
    return {static_cast<float>(middle.x + offset.x), static_cast<float>(middle.y - offset.y)};
}

std::optional<std::pair<ImVec2, ImVec2>> clipped(const Camera& camera, const CanvasRect& canvas, Vec2 a,
                                                 Vec2 b) {
    const Vec2 reach = 3.0 * Vec2(canvas.width(), canvas.height()) / camera.pixelsPerMeter;
    const Vec2 p = a - camera.center, d = b - a;
    double from = 0.0, to = 1.0;  // Liang and Barsky (1984)
    cut(p.x, d.x, reach.x, from, to);
    cut(-p.x, -d.x, reach.x, from, to);
    cut(p.y, d.y, reach.y, from, to);
    cut(-p.y, -d.y, reach.y, from, to);
    if (!(from <= to)) return std::nullopt;
    return std::pair{toScreen(camera, canvas, a + from * d), toScreen(camera, canvas, a + to * d)};
}

Vec2 toWorld(const Camera& camera, const CanvasRect& canvas, ImVec2 screen) {
    const ImVec2 middle = canvas.center();
    return camera.center + Vec2(screen.x - middle.x, middle.y - screen.y) / camera.pixelsPerMeter;
}

Camera fitted(const Bounds& bounds, const CanvasRect& canvas, float margin) {
    const Vec2 size = glm::max(bounds.size(), Vec2(1e-9));
    const double width = std::max(1.0f, canvas.width() - 2 * margin);
    const double height = std::max(1.0f, canvas.height() - 2 * margin);
    return {bounds.center(), std::min(width / size.x, height / size.y)};
}

Camera zoomed(const Camera& camera, const CanvasRect& canvas, ImVec2 screen, double factor) {
    const Vec2 fixed = toWorld(camera, canvas, screen);
    Camera result = camera;
    result.pixelsPerMeter = std::clamp(camera.pixelsPerMeter * factor, 1e-6, 1e12);
    result.center = fixed + (camera.center - fixed) * (camera.pixelsPerMeter / result.pixelsPerMeter);
    return result;
}

double roundStep(const Camera& camera, double pixels) {
    const double wanted = pixels / camera.pixelsPerMeter;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= wanted) return factor * power;
    return 10.0 * power;
}

Camera panned(const Camera& camera, ImVec2 pixels) {
    return {camera.center + Vec2(-pixels.x, pixels.y) / camera.pixelsPerMeter, camera.pixelsPerMeter};
}

}  // namespace halfdisk
