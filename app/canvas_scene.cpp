// The scene on the canvas: grid, walls with their fronts marked, lights.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/canvas.h"
#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/language.h"
#include "core/nearest_wall.h"
#include "core/overload.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostHatchedWalls = 2000;

ImU32 packed(const Rgb& color) {
    const auto byte = [](double x) { return static_cast<int>(std::lround(255.0 * std::clamp(x, 0.0, 1.0))); };
    return IM_COL32(byte(color.x), byte(color.y), byte(color.z), 255);
}

/// Short strokes on the back of a wall, as in a drawing of a solid's section.
void hatchBack(const Canvas& canvas, ImVec2 a, ImVec2 b) {
    const float length = std::hypot(b.x - a.x, b.y - a.y), spacing = canvas.px(9), depth = canvas.px(8);
    if (length < spacing) return;
    const ImVec2 along{(b.x - a.x) / length, (b.y - a.y) / length};
    const ImVec2 back{-along.y, along.x};  // screen y points down: the right side of a->b
    const int strokes = std::min(400, static_cast<int>(length / spacing));
    for (int i = 0; i < strokes; ++i) {
        const float s = (static_cast<float>(i) + 0.5f) * length / static_cast<float>(strokes);
        const ImVec2 from{a.x + along.x * s, a.y + along.y * s};
        canvas.list.AddLine(from, {from.x + (back.x - along.x) * depth, from.y + (back.y - along.y) * depth},
                            canvas.ui.palette.wallBack, canvas.px(1));
    }
}

void drawSun(const Canvas& canvas, ImVec2 at, float radius) {
    canvas.list.AddCircleFilled(at, radius, canvas.ui.palette.light);
    for (int i = 0; i < 8; ++i) {
        const float angle = static_cast<float>(i) * static_cast<float>(kPi) / 4;
        const ImVec2 ray{std::cos(angle), std::sin(angle)};
        canvas.list.AddLine({at.x + 1.4f * radius * ray.x, at.y + 1.4f * radius * ray.y},
                            {at.x + 2.1f * radius * ray.x, at.y + 2.1f * radius * ray.y},
                            canvas.ui.palette.light, canvas.px(2));
    }
}

void drawArrow(const Canvas& canvas, ImVec2 from, ImVec2 to, ImU32 color) {
    const float length = std::hypot(to.x - from.x, to.y - from.y), head = canvas.px(9);
    if (length < 1.0f) return;
    const ImVec2 along{(to.x - from.x) / length, (to.y - from.y) / length};
    canvas.list.AddLine(from, {to.x - along.x * head, to.y - along.y * head}, color, canvas.px(2));
    const ImVec2 neck{to.x - along.x * head, to.y - along.y * head};
    canvas.list.AddTriangleFilled(to, {neck.x - along.y * head / 2, neck.y + along.x * head / 2},
                                  {neck.x + along.y * head / 2, neck.y - along.x * head / 2}, color);
}

/// What a wall is made of shows beside its front; a mirror and glass are lines of their own colour.
void drawWall(const Canvas& canvas, const Segment& s, const Material& material, ImVec2 a, ImVec2 b) {
    const Palette& palette = canvas.ui.palette;
    if (std::holds_alternative<Dielectric>(material))
        return canvas.list.AddLine(a, b, palette.glass, canvas.px(2));
    const bool mirror = std::holds_alternative<Mirror>(material);
    canvas.list.AddLine(a, b, mirror ? palette.mirror : palette.wallFront, canvas.px(mirror ? 5.0f : 3.0f));
    const Rgb colour = std::visit(
        Overload{[](const Diffuse& wall) { return wall.albedo; },
                 [](const Glossy& wall) { return wall.albedo; },
                 [](const Mix& wall) { return wall.diffuse.albedo; }, [](const auto&) { return Rgb(0.0); }},
        material);
    if (!isEmitter(s) && gray(colour) < 0.02) return;
    const Vec2 normal = frontNormal(s);
    const ImVec2 front{canvas.px(3) * static_cast<float>(normal.x),
                       -canvas.px(3) * static_cast<float>(normal.y)};
    const auto beside = [&](float lines, ImU32 ink, float width) {
        canvas.list.AddLine({a.x + lines * front.x, a.y + lines * front.y},
                            {b.x + lines * front.x, b.y + lines * front.y}, ink, width);
    };
    beside(1.0f, isEmitter(s) ? palette.light : packed(colour), canvas.px(isEmitter(s) ? 5.0f : 3.0f));
    // A second, silver line: it shines.
    const bool shines = std::holds_alternative<Glossy>(material) || std::holds_alternative<Mix>(material);
    if (shines) beside(2.0f, palette.mirror, canvas.px(1.5f));
}

}  // namespace

void Canvas::line(Vec2 a, Vec2 b, ImU32 color, float thickness) const {
    if (const auto part = clipped(camera, rect, a, b))
        list.AddLine(part->first, part->second, color, thickness);
}

Vec2 Canvas::farAlong(Vec2 from, Vec2 direction) const {
    const double diagonal = std::hypot(rect.width(), rect.height()) / camera.pixelsPerMeter;
    return from + direction * (2.0 * diagonal + glm::length(from - camera.center));
}

void drawGrid(const Canvas& canvas) {
    double step = 1.0;
    while (step * canvas.camera.pixelsPerMeter < canvas.px(24)) step *= 10.0;
    while (step * canvas.camera.pixelsPerMeter > canvas.px(400)) step /= 10.0;
    const Vec2 low = toWorld(canvas.camera, canvas.rect, {canvas.rect.min.x, canvas.rect.max.y});
    const Vec2 high = toWorld(canvas.camera, canvas.rect, {canvas.rect.max.x, canvas.rect.min.y});
    // Counted, not summed up: far from the origin a step may be less than rounding.
    const Vec2 first = glm::ceil(low / step), last = glm::floor(high / step);
    const Vec2 lines = glm::min(last - first + 1.0, Vec2(1000.0));
    for (int i = 0; i < static_cast<int>(lines.x); ++i) {
        const float p = canvas.screen({(first.x + i) * step, 0.0}).x;
        canvas.list.AddLine({p, canvas.rect.min.y}, {p, canvas.rect.max.y}, canvas.ui.palette.grid, 1.0f);
    }
    for (int i = 0; i < static_cast<int>(lines.y); ++i) {
        const float p = canvas.screen({0.0, (first.y + i) * step}).y;
        canvas.list.AddLine({canvas.rect.min.x, p}, {canvas.rect.max.x, p}, canvas.ui.palette.grid, 1.0f);
    }
    const std::string words = say("grid: {:g} m", step);
    // Above the legends, which lie on the left but may be as wide as the canvas.
    const ImVec2 size = textSize(words);
    const float up = canvas.ui.state.shows(View::field) ? legendRow(canvas, 2) : legendRow(canvas, 1);
    const ImVec2 end{canvas.rect.max.x - canvas.px(6), up};
    if (fieldIsSeen(canvas))
        canvas.list.AddRectFilled({end.x - size.x - canvas.px(4), end.y},
                                  {end.x + canvas.px(4), end.y + size.y},
                                  withOpacity(canvas.ui.palette.background, 0.9f), canvas.px(4));
    drawText(canvas.ui, end, canvas.ui.palette.inkSoft, words, Align::right);
}

void drawWalls(const Canvas& canvas) {
    const Scene& scene = canvas.ui.state.scene->scene;
    const bool hatch = scene.segments.size() <= kMostHatchedWalls;
    for (const Segment& s : scene.segments) {
        const auto part = clipped(canvas.camera, canvas.rect, s.a, s.b);
        const bool oneSided = !s.twoSided && !actsOnBothSides(scene.materials[s.material]);
        if (part && hatch && oneSided) hatchBack(canvas, part->first, part->second);
    }
    // Dark lines on the dark places of a field need a light rim.
    if (fieldIsSeen(canvas))
        for (const Segment& s : scene.segments)
            canvas.line(s.a, s.b, withOpacity(canvas.ui.palette.background, 0.9f), canvas.px(7));
    for (const Segment& s : scene.segments)
        if (const auto part = clipped(canvas.camera, canvas.rect, s.a, s.b))
            drawWall(canvas, s, scene.materials[s.material], part->first, part->second);
}

void drawEye(const Canvas& canvas) {
    const auto& eye = canvas.ui.state.scene->scene.eye;
    if (!eye) return;
    const Palette& palette = canvas.ui.palette;
    const ImVec2 at = canvas.screen(eye->position);
    const float reach = canvas.px(46), middle = std::atan2(-static_cast<float>(eye->direction.y),
                                                           static_cast<float>(eye->direction.x));
    const float half = static_cast<float>(eye->fov) / 2;
    canvas.list.PathLineTo(at);
    canvas.list.PathArcTo(at, reach, middle - half, middle + half, 24);
    canvas.list.PathFillConvex(withOpacity(palette.accent, 0.10f));
    for (const float edge : {middle - half, middle + half})
        canvas.list.AddLine(at, {at.x + reach * std::cos(edge), at.y + reach * std::sin(edge)},
                            palette.accent, canvas.px(1.5f));
    canvas.list.AddCircleFilled(at, canvas.px(6), palette.accent);
    canvas.list.AddCircleFilled(at, canvas.px(2.5f), palette.panel);
}

void drawLights(const Canvas& canvas) {
    const Palette& palette = canvas.ui.palette;
    float sunRow = 0.0f;
    for (const DeltaLight& light : canvas.ui.state.scene->scene.lights) {
        if (const auto* point = std::get_if<PointLight>(&light))
            drawSun(canvas, canvas.screen(point->position), canvas.px(7));
        if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
            const Vec2 direction = glm::normalize(sun->direction);
            const ImVec2 start{
                std::max(canvas.rect.center().x - canvas.px(200), canvas.rect.min.x + canvas.px(20)),
                canvas.rect.min.y + canvas.px(30 + sunRow)};
            const ImVec2 step{canvas.px(48) * static_cast<float>(direction.x),
                              -canvas.px(48) * static_cast<float>(direction.y)};
            for (int i = 0; i < 4; ++i) {
                const ImVec2 from{start.x + canvas.px(40) * static_cast<float>(i), start.y};
                drawArrow(canvas, from, {from.x + step.x, from.y + step.y}, palette.light);
            }
            sunRow += 60.0f;
        }
    }
}

WallPoint nearestWallPoint(const Scene& scene, Vec2 world) {
    const NearestWall nearest = nearestWall(scene, world);
    return {nearest.segment, nearest.t};
}

}  // namespace halfdisk
