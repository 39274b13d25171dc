#include "app/rich_text.h"

#include <algorithm>
#include <string_view>

#include "app/draw_text.h"
#include "app/line_breaks.h"

namespace halfdisk {
namespace {

/// A word that is not broken, with the space before it if there is one.
struct Word {
    std::string_view text;
    const Span* span;
    bool spaceBefore;
};

// Code is not broken at its spaces, unless it is longer than a narrow column.
constexpr std::size_t kMostOfWholeCode = 24;

std::vector<Word> wordsOf(const Paragraph& paragraph) {
    std::vector<Word> words;
    bool space = false;
    for (const Span& span : paragraph.spans) {
        std::string_view rest = span.text;
        while (!rest.empty()) {
            const std::size_t begin = rest.find_first_not_of(' ');
            if (begin != 0) space = true;
            if (begin == std::string_view::npos) break;
            rest.remove_prefix(begin);
            const bool whole = span.style == SpanStyle::code && rest.size() <= kMostOfWholeCode;
            const std::size_t end = whole ? rest.size() : endOfWord(rest);
            words.push_back({rest.substr(0, end), &span, space && !words.empty()});
            rest.remove_prefix(end);
            space = false;
        }
    }
    return words;
}

ImFont* fontOf(const Fonts& fonts, SpanStyle style) {
    switch (style) {
        case SpanStyle::strong:
            return fonts.strong;
        case SpanStyle::emphasis:
            return fonts.emphasis;
        case SpanStyle::code:
            return fonts.code;
        case SpanStyle::plain:
        case SpanStyle::term:
            break;
    }
    return fonts.prose;
}

/// Words that touch each other ("P" and "," of another style) break as one.
std::size_t endOfCluster(const std::vector<Word>& words, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < words.size() && !words[end].spaceBefore) ++end;
    return end;
}

float widthOf(const Fonts& fonts, const Word& word) {
    return textSize(word.text, fontOf(fonts, word.span->style)).x;
}

void drawWord(const Ui& ui, const Word& word, ImVec2 at, float lineHeight, const std::vector<Term>& terms) {
    ImFont* font = fontOf(ui.fonts, word.span->style);
    const bool term = word.span->style == SpanStyle::term;
    const ImVec2 size = textSize(word.text, font);
    at.y += (lineHeight - size.y) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (word.span->style == SpanStyle::code)
        list.AddRectFilled({at.x - ui.scale, at.y}, {at.x + size.x + ui.scale, at.y + size.y},
                           ui.palette.grid, 2 * ui.scale);
    drawText(ui, at, term ? ui.palette.accent : ui.palette.ink, word.text, Align::left, font);
    if (!term) return;
    const ImVec2 end{at.x + size.x, at.y + size.y};
    for (float x = at.x; x < end.x; x += 5 * ui.scale)
        list.AddLine({x, end.y - ui.scale}, {std::min(x + 3 * ui.scale, end.x), end.y - ui.scale},
                     ui.palette.accent, ui.scale);
    if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(at, end)) return;
    const Term& meant = terms[word.span->term];
    if (meant.topic != Topic::none) ui.commands.push_back(LightTopic{meant.topic});
    ImGui::BeginTooltip();
    ImGui::PushFont(ui.fonts.strong);
    tooltipWords(meant.name, 22.0f);
    ImGui::PopFont();
    tooltipWords(meant.meaning, 22.0f);
    ImGui::EndTooltip();
}

/// Returns the height used.
float drawParagraph(const Ui& ui, const Paragraph& paragraph, ImVec2 origin, float width,
                    const std::vector<Term>& terms) {
    const float lineHeight = 1.24f * ui.fonts.prose->FontSize;
    const float space = textSize(" ", ui.fonts.prose).x;
    const std::vector<Word> words = wordsOf(paragraph);
    ImVec2 at = origin;
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = endOfCluster(words, begin);
        float cluster = 0.0f;
        for (std::size_t i = begin; i < end; ++i) cluster += widthOf(ui.fonts, words[i]);
        const bool first = at.x == origin.x;
        if (!first && at.x + space + cluster > origin.x + width)
            at = {origin.x, at.y + lineHeight};
        else if (!first)
            at.x += space;
        for (; begin < end; ++begin) {
            drawWord(ui, words[begin], at, lineHeight, terms);
            at.x += widthOf(ui.fonts, words[begin]);
        }
    }
    return at.y + lineHeight - origin.y;
}

/// Broken at spaces if it is too long for one line; later lines are indented.
std::vector<std::string_view> formulaLines(std::string_view words, ImFont* font, float width) {
    std::vector<std::string_view> lines;
    while (textSize(words, font).x > width) {
        std::size_t end = words.rfind(' ');
        while (end != std::string_view::npos && textSize(words.substr(0, end), font).x > width)
            end = end == 0 ? std::string_view::npos : words.rfind(' ', end - 1);
        if (end == std::string_view::npos || end == 0) break;
        lines.push_back(words.substr(0, end));
        words.remove_prefix(end + 1);
    }
    lines.push_back(words);
    return lines;
}

float drawFormula(const Ui& ui, std::string_view words, ImVec2 origin, float width) {
    ImFont* font = ui.fonts.formula;
    const float gap = 4 * ui.scale, indent = 10 * ui.scale;
    const std::vector<std::string_view> lines = formulaLines(words, font, width - 3 * indent);
    const float row = 1.15f * font->FontSize, height = row * static_cast<float>(lines.size()) + 2 * gap;
    ImGui::GetWindowDrawList()->AddRectFilled(origin, {origin.x + width, origin.y + height},
                                              withOpacity(ui.palette.halfDisk, 0.15f), 4 * ui.scale);
    ImVec2 at{origin.x + indent, origin.y + gap};
    for (const std::string_view line : lines) {
        drawText(ui, at, ui.palette.ink, line, Align::left, font);
        at = {origin.x + 2 * indent, at.y + row};
    }
    return height;
}

}  // namespace

void richText(const Ui& ui, const Prose& prose, const std::vector<Term>& terms) {
    const float width = ImGui::GetContentRegionAvail().x;
    for (const Paragraph& paragraph : prose) {
        const ImVec2 origin = ImGui::GetCursorScreenPos();
        const float height =
            paragraph.kind == ParagraphKind::formula
                ? drawFormula(ui, paragraph.spans.empty() ? "" : paragraph.spans[0].text, origin, width)
                : drawParagraph(ui, paragraph, origin, width, terms);
        ImGui::Dummy({width, height + 2 * ui.scale});
    }
}

}  // namespace halfdisk
