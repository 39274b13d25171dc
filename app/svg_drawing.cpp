#include "app/svg_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/png_image.h"
#include "app/xml_text.h"

namespace halfdisk {
namespace {

/// Two decimals at most, no negative zero.
std::string number(double value) {
    if (!std::isfinite(value)) return "0";
    const double rounded = std::round(value * 100.0) / 100.0 + 0.0;
    std::string text = fmt::format("{:.2f}", rounded);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

unsigned channel(ImU32 color, int shift) {
    return (color >> shift) & 255u;
}

bool isOpaque(ImU32 color) {
    return channel(color, IM_COL32_A_SHIFT) == 255u;
}

bool isInvisible(ImU32 color) {
    return channel(color, IM_COL32_A_SHIFT) == 0u;
}

/// ` fill="#rrggbb"`, and how opaque.
std::string paint(std::string_view property, ImU32 color) {
    std::string text = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", property, channel(color, IM_COL32_R_SHIFT),
                                   channel(color, IM_COL32_G_SHIFT), channel(color, IM_COL32_B_SHIFT));
    if (!isOpaque(color))
        text += fmt::format(" {}-opacity=\"{}\"", property, number(channel(color, IM_COL32_A_SHIFT) / 255.0));
    return text;
}

/// As wide as ImGui draws it.
std::string stroke(ImU32 color, float width) {
    return fmt::format(" fill=\"none\"{} stroke-width=\"{}\"", paint("stroke", color),
                       number(std::max(width, 1.0f)));
}

std::string fontOf(const TypeFace& face) {
    std::string text = fmt::format(" font-family=\"{}{}DejaVu Sans, sans-serif\" font-size=\"{}\"",
                                   xmlText(face.family), face.family.empty() ? "" : ", ", number(face.em));
    if (face.bold) text += " font-weight=\"bold\"";
    if (face.italic) text += " font-style=\"italic\"";
    return text;
}

}  // namespace

SvgDrawing::SvgDrawing(std::string name, ImVec2 min, ImVec2 max, ImU32 ground)
    : name_(std::move(name)), min_(min), max_(max), ground_(ground) {}

std::string SvgDrawing::place(ImVec2 at) const {
    return number(at.x - min_.x) + " " + number(at.y - min_.y);
}

std::string SvgDrawing::way(std::span<const ImVec2> points) const {
    std::string text;
    for (const ImVec2& point : points) {
        text += text.empty() ? 'M' : 'L';
        text += place(point);
    }
    return text;
}

void SvgDrawing::add(std::string_view element) {
    endStrokes();
    body_ += element;
    body_ += '\n';
}

void SvgDrawing::endStrokes() {
    if (strokes_.empty()) return;
    body_ += fmt::format("<path d=\"{}\"{}/>\n", strokes_, strokeStyle_);
    strokes_.clear();
}

void SvgDrawing::line(ImVec2 a, ImVec2 b, ImU32 color, float width) {
    if (isInvisible(color)) return;
    const std::string style = stroke(color, width);
    // Of lines that let others through, each covers those before it.
    if (!isOpaque(color) || style != strokeStyle_) endStrokes();
    strokeStyle_ = style;
    strokes_ += fmt::format("M{}L{}", place(a), place(b));
    if (!isOpaque(color)) endStrokes();
}

void SvgDrawing::polyline(std::span<const ImVec2> points, ImU32 color, bool closed, float width) {
    if (isInvisible(color) || points.size() < 2) return;
    add(fmt::format("<path d=\"{}{}\"{} stroke-linejoin=\"round\"/>", way(points), closed ? "Z" : "",
                    stroke(color, width)));
}

void SvgDrawing::polygon(std::span<const ImVec2> points, ImU32 color) {
    if (isInvisible(color) || points.size() < 3) return;
    add(fmt::format("<path d=\"{}Z\"{}/>", way(points), paint("fill", color)));
}

void SvgDrawing::rect(ImVec2 min, ImVec2 max, ImU32 color, float rounding, float width) {
    if (isInvisible(color)) return;
    add(fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{}/>", number(min.x - min_.x),
        number(min.y - min_.y), number(std::max(0.0f, max.x - min.x)), number(std::max(0.0f, max.y - min.y)),
        rounding > 0.0f ? fmt::format(" rx=\"{}\"", number(rounding)) : "", stroke(color, width)));
}

void SvgDrawing::rectFilled(ImVec2 min, ImVec2 max, ImU32 color, float rounding) {
    if (isInvisible(color)) return;
    const auto [left, right] = std::minmax(min.x, max.x);
    const auto [top, bottom] = std::minmax(min.y, max.y);
    // Those without round corners have hard edges, as on the screen: neighbours show no seam.
    add(fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{}/>", number(left - min_.x),
                    number(top - min_.y), number(right - left), number(bottom - top),
                    rounding > 0.0f ? fmt::format(" rx=\"{}\"", number(rounding))
                                    : std::string(" shape-rendering=\"crispEdges\""),
                    paint("fill", color)));
}

void SvgDrawing::circle(ImVec2 center, float radius, ImU32 color, float width) {
    if (isInvisible(color) || !(radius > 0.0f)) return;
    add(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>", number(center.x - min_.x),
                    number(center.y - min_.y), number(radius), stroke(color, width)));
}

void SvgDrawing::circleFilled(ImVec2 center, float radius, ImU32 color) {
    if (isInvisible(color) || !(radius > 0.0f)) return;
    add(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>", number(center.x - min_.x),
                    number(center.y - min_.y), number(radius), paint("fill", color)));
}

void SvgDrawing::cells(ImVec2 min, ImVec2 max, std::span<const std::uint32_t> colors, std::uint32_t columns,
                       float opacity) {
    if (colors.empty() || columns == 0) return;
    const auto rows = static_cast<std::uint32_t>(colors.size() / columns);
    // Not every viewer keeps cells sharp when it magnifies them: those of several pixels are.
    constexpr std::uint32_t kSide = 2048, kMostTimes = 16;
    const std::uint32_t times = std::clamp(kSide / std::max(columns, rows), 1u, kMostTimes);
    Image image{static_cast<int>(columns * times), static_cast<int>(rows * times), {}};
    image.rgba.reserve(std::size_t{4} * times * times * colors.size());
    for (std::uint32_t y = 0; y < rows * times; ++y)
        for (std::uint32_t x = 0; x < columns * times; ++x)
            for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT, IM_COL32_A_SHIFT})
                image.rgba.push_back(static_cast<std::uint8_t>(
                    channel(colors[std::size_t{y / times} * columns + x / times], shift)));
    addImage(min, max, image,
             fmt::format("{} style=\"image-rendering:optimizeSpeed;image-rendering:pixelated\"",
                         opacity < 1.0f ? fmt::format(" opacity=\"{}\"", number(opacity)) : ""));
}

void SvgDrawing::picture(ImVec2 min, ImVec2 max, const Image& premultiplied) {
    if (premultiplied.rgba.empty()) return;
    Image image = premultiplied;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        const unsigned opacity = image.rgba[i + 3];
        for (std::size_t k = i; opacity > 0 && k < i + 3; ++k)
            image.rgba[k] =
                static_cast<std::uint8_t>(std::min(255u, (image.rgba[k] * 255u + opacity / 2) / opacity));
    }
    addImage(min, max, image, "");
}

void SvgDrawing::addImage(ImVec2 min, ImVec2 max, const Image& image, std::string_view attributes) {
    add(
        fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\"{} "
                    "xlink:href=\"data:image/png;base64,{}\"/>",
                    number(min.x - min_.x), number(min.y - min_.y), number(max.x - min.x),
                    number(max.y - min.y), attributes, base64(encodePng(image))));
}

void SvgDrawing::text(ImVec2 at, float width, ImU32 color, std::string_view words, const TypeFace& face) {
    if (isInvisible(color) || words.empty()) return;
    const bool spaced = words.front() == ' ' || words.back() == ' ' || words.find("  ") != words.npos;
    add(fmt::format(
        "<text x=\"{}\" y=\"{}\" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"{}{}{}>{}</text>",
        number(at.x - min_.x), number(at.y - min_.y), number(width), fontOf(face), paint("fill", color),
        spaced ? " xml:space=\"preserve\"" : "", xmlText(words)));
}

void SvgDrawing::pushClip(ImVec2 min, ImVec2 max) {
    ++openClips_;
    const std::string id = fmt::format("{}-clip{}", name_, ++clips_);
    add(
        fmt::format("<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n"
                    "<g clip-path=\"url(#{})\">",
                    id, number(min.x - min_.x), number(min.y - min_.y), number(std::max(0.0f, max.x - min.x)),
                    number(std::max(0.0f, max.y - min.y)), id));
}

void SvgDrawing::popClip() {
    if (openClips_ == 0) return;
    --openClips_;
    add("</g>");
}

std::string SvgDrawing::svg(std::string_view title, std::string_view description) const {
    const std::string width = number(max_.x - min_.x), height = number(max_.y - min_.y);
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
        "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
        "aria-labelledby=\"{2}-title {2}-words\">\n"
        "<title id=\"{2}-title\">{3}</title>\n<desc id=\"{2}-words\">{4}</desc>\n"
        "<rect width=\"{0}\" height=\"{1}\"{5}/>\n",
        width, height, xmlText(name_), xmlText(title), xmlText(description), paint("fill", ground_));
    text += body_;
    if (!strokes_.empty()) text += fmt::format("<path d=\"{}\"{}/>\n", strokes_, strokeStyle_);
    for (int i = 0; i < openClips_; ++i) text += "</g>\n";
    return text + "</svg>\n";
}

}  // namespace halfdisk
