// How does what is drawn become an SVG? One element for each call; numbers have two decimals, so that the
// same drawing gives the same bytes.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "app/fonts.h"
#include "app/png_image.h"

namespace halfdisk {

/// A part of the screen. All places are pixels of the screen; colours are ImGui's, with opacity.
class SvgDrawing {
 public:
    SvgDrawing(std::string name, ImVec2 min, ImVec2 max, ImU32 ground);

    const std::string& name() const { return name_; }

    void line(ImVec2 a, ImVec2 b, ImU32 color, float width);
    void polyline(std::span<const ImVec2> points, ImU32 color, bool closed, float width);
    void polygon(std::span<const ImVec2> points, ImU32 color);  ///< filled
    void rect(ImVec2 min, ImVec2 max, ImU32 color, float rounding, float width);
    void rectFilled(ImVec2 min, ImVec2 max, ImU32 color, float rounding);
    void circle(ImVec2 center, float radius, ImU32 color, float width);
    void circleFilled(ImVec2 center, float radius, ImU32 color);
    /// Rows of cells from the top, of equal size, stretched over the rectangle without blur.
    void cells(ImVec2 min, ImVec2 max, std::span<const std::uint32_t> colors, std::uint32_t columns,
               float opacity);
    /// Stretched over the rectangle, smoothly. Premultiplied.
    void picture(ImVec2 min, ImVec2 max, const Image& premultiplied);
    /// One line; `at` is the left end of its baseline. In other fonts it is as wide.
    void text(ImVec2 at, float width, ImU32 color, std::string_view words, const TypeFace& face);

    void pushClip(ImVec2 min, ImVec2 max);
    void popClip();

    /// The whole file. `title` and `description` are for those who do not see it.
    std::string svg(std::string_view title, std::string_view description) const;

 private:
    std::string place(ImVec2 at) const;                     // "x y"
    std::string way(std::span<const ImVec2> points) const;  // from one to the next
    void add(std::string_view element);
    void addImage(ImVec2 min, ImVec2 max, const Image& image, std::string_view attributes);
    void endStrokes();

    std::string name_;
    ImVec2 min_, max_;
    ImU32 ground_;
    std::string body_;
    std::string strokes_, strokeStyle_;  // opaque lines of one style that follow each other: one path
    int clips_ = 0, openClips_ = 0;
};

}  // namespace halfdisk
