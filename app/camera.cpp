#include "app/camera.h"

#include <algorithm>

namespace halfdisk {
namespace {

// ImGui's coordinates are floats; what lies further out than this is off the screen anyway.
constexpr double kFarPixels = 1e6;

float pixel(double x) {
    return static_cast<float>(std::clamp(x, -kFarPixels, kFarPixels));
}

}  // namespace

ImVec2 toScreen(const Camera& camera, const CanvasRect& canvas, Vec2 world) {
    const ImVec2 middle = canvas.center();
    const Vec2 offset = (world - camera.center) * camera.pixelsPerMeter;
    return {pixel(middle.x + offset.x), pixel(middle.y - offset.y)};
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

Camera panned(const Camera& camera, ImVec2 pixels) {
    return {camera.center + Vec2(-pixels.x, pixels.y) / camera.pixelsPerMeter, camera.pixelsPerMeter};
}

}  // namespace halfdisk
