// How does a lesson's text become paragraphs, emphasis, terms and formulas?
#include "lessons/prose.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/suggestions.h"
#include "lessons/utf8.h"

namespace halfdisk {
namespace {

constexpr std::string_view kEscapable = "\\*`[]|$";
constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool isEscape(std::string_view text, std::size_t at) {
    return text[at] == '\\' && at + 1 < text.size() &&
           kEscapable.find(text[at + 1]) != std::string_view::npos;
}

/// Offset of the first `mark` at or behind `from` that no backslash precedes.
std::size_t findUnescaped(std::string_view text, std::string_view mark, std::size_t from) {
    for (std::size_t i = from; i < text.size(); ++i) {
        if (isEscape(text, i)) {
            ++i;
        } else if (text.substr(i, mark.size()) == mark) {
            return i;
        }
    }
    return std::string_view::npos;
}

/// Escapes resolved, runs of blanks and line breaks made one space.
std::string shown(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (isEscape(text, i)) {
            result += text[++i];
        } else if (kBlanks.find(text[i]) == std::string_view::npos) {
            result += text[i];
        } else if (result.empty() || result.back() != ' ') {
            result += ' ';
        }
    }
    return result;
}

/// Reads the markup within one paragraph.
class SpanReader {
 public:
    SpanReader(std::string_view text, const std::vector<Term>& terms) : text_(text), terms_(terms) {}

    std::vector<Span> read() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (isEscape(text_, at_)) {
                at_ += 2;
            } else if (c == '`') {
                readMarked("`", SpanStyle::code);
            } else if (c == '*') {
                readStars();
            } else if (c == '[') {
                readTerm();
            } else {
                ++at_;
            }
        }
        endPlain();
        return std::move(spans_);
    }

 private:
    [[noreturn]] void fail(std::size_t where, const std::string& message) const {
        const std::string_view rest = text_.substr(where);
        throw MarkupError(message, std::string(rest.substr(0, rest.find('\n'))));
    }

    void endPlain() {
        if (at_ > plainFrom_)
            spans_.push_back({SpanStyle::plain, shown(text_.substr(plainFrom_, at_ - plainFrom_))});
    }

    void readStars() {
        const std::string_view mark = text_.substr(at_, 2) == "**" ? "**" : "*";
        const std::size_t behind = at_ + mark.size();
        if (behind >= text_.size() || kBlanks.find(text_[behind]) != std::string_view::npos) {
            at_ = behind;  // "2 * 3" is no emphasis
        } else {
            readMarked(mark, mark == "*" ? SpanStyle::emphasis : SpanStyle::strong);
        }
    }

    void readMarked(std::string_view mark, SpanStyle style) {
        const std::size_t start = at_ + mark.size();
        const std::size_t end = findUnescaped(text_, mark, start);
        if (end == std::string_view::npos)
            fail(at_,
                 fmt::format(
                     "{0} is never closed, expected another {0} in the same paragraph (write \\{1} for the "
                     "character itself, or \\\\{1} between \")",
                     mark, mark[0]));
        const std::string_view inner = text_.substr(start, end - start);
        if (trimmed(inner).empty())
            fail(at_, fmt::format("there is nothing between {0} and {0}, expected words", mark));
        if (style != SpanStyle::code)
            for (const std::string_view other : {"*", "`", "["})
                if (findUnescaped(inner, other, 0) != std::string_view::npos)
                    fail(at_, fmt::format("{} inside {}, expected plain words: markup does not nest", other,
                                          mark));
        add(style, inner, 0, end + mark.size());
    }

    void readTerm() {
        const std::size_t end = findUnescaped(text_, "]", at_ + 1);
        if (end == std::string_view::npos)
            fail(at_,
                 "[ is never closed, expected ] in the same paragraph (write \\[ for the character itself, "
                 "or \\\\[ between \")");
        const std::string_view inner = text_.substr(at_ + 1, end - at_ - 1);
        const std::size_t bar = findUnescaped(inner, "|", 0);
        const bool hasWords = bar != std::string_view::npos;
        const std::string name = shown(trimmed(hasWords ? inner.substr(bar + 1) : inner));
        const std::size_t term = findTerm(terms_, name);
        if (term == terms_.size()) {
            std::vector<std::string_view> names;
            for (const Term& known : terms_) names.push_back(known.name);
            fail(at_, names.empty()
                          ? fmt::format("[{}] names no term, expected a [[term]] of that name in the file",
                                        excerpt(name))
                          : fmt::format("[{}] names no term, {}", excerpt(name), expectedOneOf(name, names)));
        }
        const std::string_view words = hasWords ? inner.substr(0, bar) : inner;
        if (trimmed(words).empty()) fail(at_, "there are no words before |, expected [shown words|term]");
        add(SpanStyle::term, trimmed(words), term, end + 1);
    }

    void add(SpanStyle style, std::string_view words, std::size_t term, std::size_t behind) {
        endPlain();
        spans_.push_back({style, shown(words), term});
        at_ = plainFrom_ = behind;
    }

    std::string_view text_;
    const std::vector<Term>& terms_;
    std::vector<Span> spans_;
    std::size_t at_ = 0;
    std::size_t plainFrom_ = 0;
};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::size_t findTerm(const std::vector<Term>& terms, std::string_view name) {
    const auto sameLetter = [](char a, char b) { return lower(a) == lower(b); };
    const auto found = std::find_if(terms.begin(), terms.end(), [&](const Term& term) {
        return std::equal(term.name.begin(), term.name.end(), name.begin(), name.end(), sameLetter);
    });
    return static_cast<std::size_t>(found - terms.begin());
}

Prose parseProse(std::string_view text, const std::vector<Term>& terms) {
    Prose prose;
    std::string paragraph;  // its lines so far, joined by '\n'
    const auto endParagraph = [&] {
        if (!paragraph.empty()) prose.push_back({ParagraphKind::text, SpanReader(paragraph, terms).read()});
        paragraph.clear();
    };
    while (!text.empty()) {
        const std::size_t newline = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, newline));
        text.remove_prefix(std::min(newline + 1, text.size()));
        if (line.empty()) {
            endParagraph();
        } else if (line.substr(0, 2) == "$ ") {
            endParagraph();
            prose.push_back(
                {ParagraphKind::formula, {{SpanStyle::plain, std::string(trimmed(line.substr(2)))}}});
        } else {
            if (!paragraph.empty()) paragraph += '\n';
            paragraph += line;
        }
    }
    endParagraph();
    return prose;
}

std::string plainText(const Prose& prose) {
    std::string text;
    for (const Paragraph& paragraph : prose) {
        if (!text.empty()) text += '\n';
        for (const Span& span : paragraph.spans) text += span.text;
    }
    return text;
}

}  // namespace halfdisk
