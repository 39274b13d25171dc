#include "app/words_page.h"

#include <fmt/format.h>

#include "lessons/utf8.h"

namespace halfdisk {

/// Broken between words; one that is longer than a line stands alone.
void WordsPage::lines(std::string_view words, std::string_view first, std::string_view later) {
    text_ += first;
    std::size_t column = characterCount(first);
    bool begun = false;
    while (!words.empty()) {
        const std::size_t start = words.find_first_not_of(' ');
        if (start == std::string_view::npos) break;
        words.remove_prefix(start);
        const std::string_view word = words.substr(0, words.find(' '));
        words.remove_prefix(word.size());
        const std::size_t width = characterCount(word);
        if (begun && column + 1 + width > kColumns) {
            text_ += '\n';
            text_ += later;
            column = characterCount(later);
        } else if (begun) {
            text_ += ' ';
            ++column;
        }
        text_ += word;
        column += width;
        begun = true;
    }
    text_ += '\n';
}

void WordsPage::underlined(std::string_view words, char with) {
    if (!text_.empty()) text_ += '\n';
    lines(words, "", "");
    text_ += std::string(std::min(characterCount(words), kColumns), with);
    text_ += '\n';
}

void WordsPage::title(std::string_view words) {
    underlined(words, '=');
}

void WordsPage::heading(std::string_view words) {
    underlined(words, '-');
}

void WordsPage::paragraph(std::string_view words) {
    while (!words.empty()) {
        const std::string_view line = words.substr(0, words.find('\n'));
        words.remove_prefix(std::min(words.size(), line.size() + 1));
        if (!line.empty()) lines(line, "", "");
    }
}

void WordsPage::prose(std::string_view words) {
    for (bool first = true; !words.empty(); first = false) {
        const std::string_view line = words.substr(0, words.find('\n'));
        words.remove_prefix(std::min(words.size(), line.size() + 1));
        if (!first) text_ += '\n';
        lines(line, "", "");
    }
}

void WordsPage::item(std::string_view words) {
    lines(words, "- ", "  ");
}

void WordsPage::fact(std::string_view name, std::string_view value) {
    lines(value, fmt::format("{}: ", name), "  ");
}

}  // namespace halfdisk
