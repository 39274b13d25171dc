// With what do canvas, plots and strips draw? With ImGui's own calls, by their own names; what they draw also
// goes to the sheet, if one is open.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "app/sheet.h"
#include "app/textures.h"

namespace halfdisk {

struct Pen {
    ImDrawList& screen;   ///< alone: what is drawn here must be told to the sheet by other means
    SvgDrawing* drawing;  ///< null: none

    void AddLine(ImVec2 a, ImVec2 b, ImU32 color, float thickness = 1.0f) const {
        screen.AddLine(a, b, color, thickness);
        if (drawing) drawing->line(middleOf(a), middleOf(b), color, thickness);
    }
    void AddRect(ImVec2 min, ImVec2 max, ImU32 color, float rounding = 0.0f,
                 ImDrawFlags flags = ImDrawFlags_None, float thickness = 1.0f) const {
        screen.AddRect(min, max, color, rounding, flags, thickness);
        if (drawing) drawing->rect(middleOf(min), {max.x - 0.5f, max.y - 0.5f}, color, rounding, thickness);
    }
    void AddRectFilled(ImVec2 min, ImVec2 max, ImU32 color, float rounding = 0.0f) const {
        screen.AddRectFilled(min, max, color, rounding);
        if (drawing) drawing->rectFilled(min, max, color, rounding);
    }
    void AddCircle(ImVec2 center, float radius, ImU32 color, int segments = 0, float thickness = 1.0f) const {
        screen.AddCircle(center, radius, color, segments, thickness);
        if (drawing) drawing->circle(center, radius - 0.5f, color, thickness);
    }
    void AddCircleFilled(ImVec2 center, float radius, ImU32 color, int segments = 0) const {
        screen.AddCircleFilled(center, radius, color, segments);
        if (drawing) drawing->circleFilled(center, radius, color);
    }
    void AddTriangleFilled(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 color) const {
        screen.AddTriangleFilled(a, b, c, color);
        if (drawing) drawing->polygon(std::vector{a, b, c}, color);
    }
    void AddPolyline(const ImVec2* points, int count, ImU32 color, ImDrawFlags flags, float thickness) const {
        screen.AddPolyline(points, count, color, flags, thickness);
        if (drawing)
            drawing->polyline({points, static_cast<std::size_t>(count)}, color,
                              (flags & ImDrawFlags_Closed) != 0, thickness);
    }
    /// Stretched over the rectangle, which may be far larger than the screen; premultiplied.
    void AddPicture(const std::shared_ptr<const Image>& picture, ImVec2 min, ImVec2 max) const {
        if (drawing) drawing->picture(min, max, *picture);
        // What is in sight of it.
        const ImVec2 low = screen.GetClipRectMin(), high = screen.GetClipRectMax();
        const ImVec2 a{std::max(min.x, low.x), std::max(min.y, low.y)},
            b{std::min(max.x, high.x), std::min(max.y, high.y)};
        Textures* textures = currentTextures();
        if (!textures || !(a.x < b.x) || !(a.y < b.y)) return;
        const ImVec2 size{max.x - min.x, max.y - min.y};
        screen.AddImage(textures->idOf(picture), a, b, {(a.x - min.x) / size.x, (a.y - min.y) / size.y},
                        {(b.x - min.x) / size.x, (b.y - min.y) / size.y});
    }
    void PathLineTo(ImVec2 at) const { screen.PathLineTo(at); }
    void PathArcTo(ImVec2 center, float radius, float from, float to, int segments = 0) const {
        screen.PathArcTo(center, radius, from, to, segments);
    }
    void PathFillConvex(ImU32 color) const {
        if (drawing) drawing->polygon(path(), color);
        screen.PathFillConvex(color);
    }
    void PathStroke(ImU32 color, ImDrawFlags flags = ImDrawFlags_None, float thickness = 1.0f) const {
        if (drawing) drawing->polyline(path(), color, (flags & ImDrawFlags_Closed) != 0, thickness);
        screen.PathStroke(color, flags, thickness);
    }
    void PushClipRect(ImVec2 min, ImVec2 max, bool intersect) const {
        screen.PushClipRect(min, max, intersect);
        if (drawing) drawing->pushClip(min, max);
    }
    void PopClipRect() const {
        screen.PopClipRect();
        if (drawing) drawing->popClip();
    }

    /// What lies between a curve (pixels, from left to right) and a level below it.
    void areaBelow(std::span<const ImVec2> curve, float level, ImU32 color) const {
        if (curve.size() < 2) return;
        const ImDrawListFlags smooth = screen.Flags;
        // Else every slice gets soft edges, and the area stripes.
        screen.Flags &= ~ImDrawListFlags_AntiAliasedFill;
        for (std::size_t i = 1; i < curve.size(); ++i)
            screen.AddQuadFilled(curve[i - 1], curve[i], {curve[i].x, level}, {curve[i - 1].x, level}, color);
        screen.Flags = smooth;
        if (!drawing) return;
        std::vector<ImVec2> outline(curve.begin(), curve.end());
        outline.push_back({curve.back().x, level});
        outline.push_back({curve.front().x, level});
        drawing->polygon(outline, color);
    }

 private:
    /// ImGui draws lines through the middles of pixels.
    static ImVec2 middleOf(ImVec2 at) { return {at.x + 0.5f, at.y + 0.5f}; }
    std::span<const ImVec2> path() const {
        return {screen._Path.Data, static_cast<std::size_t>(screen._Path.Size)};
    }
};

/// Of the current window.
inline Pen penOf(const Ui& ui) {
    return {*ImGui::GetWindowDrawList(), ui.sheet && ui.sheet->open ? &*ui.sheet->open : nullptr};
}

inline void addPolyline(const Pen& pen, std::span<const ImVec2> points, ImU32 color, bool closed,
                        float thickness) {
    pen.AddPolyline(points.data(), static_cast<int>(points.size()), color,
                    closed ? ImDrawFlags_Closed : ImDrawFlags_None, thickness);
}

inline void addRect(const Pen& pen, ImVec2 min, ImVec2 max, ImU32 color, float rounding, float thickness) {
    pen.AddRect(min, max, color, rounding, ImDrawFlags_None, thickness);
}

}  // namespace halfdisk
