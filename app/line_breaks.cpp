#include "app/line_breaks.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

namespace halfdisk {
namespace {

float widthOfWord(std::string_view word) {
    return ImGui::GetFont()
        ->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0.0f, word.data(), word.data() + word.size())
        .x;
}

void appendBroken(std::string& lines, std::string_view line, float width) {
    const float space = widthOfWord(" ");
    float x = 0.0f;
    while (!line.empty()) {
        const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
        const std::string_view gap = line.substr(0, begin);
        line.remove_prefix(begin);
        const std::string_view word = line.substr(0, endOfWord(line));
        line.remove_prefix(word.size());
        const float before = space * static_cast<float>(gap.size()), wide = widthOfWord(word);
        if (x > 0.0f && x + before + wide > width) {
            lines += '\n';
            x = wide;
        } else {
            lines += gap;
            x += before + wide;
        }
        lines += word;
    }
}

}  // namespace

std::size_t endOfWord(std::string_view text) {
    std::size_t end = text.find(' ');
    if (end != std::string_view::npos && text.substr(end).starts_with(" %")) end = text.find(' ', end + 1);
    return std::min(end, text.size());
}

std::string brokenInto(std::string_view words, float width) {
    std::string lines;
    lines.reserve(words.size() + 8);
    for (;;) {
        const std::size_t end = words.find('\n');
        appendBroken(lines, words.substr(0, end), width);
        if (end == std::string_view::npos) return lines;
        lines += '\n';
        words.remove_prefix(end + 1);
    }
}

}  // namespace halfdisk
