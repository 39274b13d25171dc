// How does a lesson's text become paragraphs, emphasis, terms and formulas?
//
//   Paragraphs are separated by blank lines. **strong**, *emphasis*, `code`, [term] and [shown words|term] do
//   not nest. A line that starts with "$ " is a formula on a line of its own, taken as it stands. A backslash
//   before one of \ * ` [ ] | $ takes away its meaning. A * followed by a space is just a star.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/topic.h"

namespace halfdisk {

/// A word of the lesson that explains itself on hover.
struct Term {
    std::string name;
    std::string meaning;
    Topic topic = Topic::none;  ///< what lights up while it is looked up
    bool operator==(const Term&) const = default;
};

enum class SpanStyle : std::uint8_t { plain, strong, emphasis, code, term };

struct Span {
    SpanStyle style = SpanStyle::plain;
    std::string text;      ///< as shown: one line, no markup
    std::size_t term = 0;  ///< index into the lesson's terms, for SpanStyle::term
    bool operator==(const Span&) const = default;
};

enum class ParagraphKind : std::uint8_t { text, formula };

struct Paragraph {
    ParagraphKind kind = ParagraphKind::text;
    std::vector<Span> spans;  ///< a formula has one plain span
    bool operator==(const Paragraph&) const = default;
};

using Prose = std::vector<Paragraph>;

/// Markup that cannot be read. what() says what is wrong and what was expected.
struct MarkupError : std::runtime_error {
    MarkupError(const std::string& message, std::string culprit)
        : std::runtime_error(message), snippet(std::move(culprit)) {}
    std::string snippet;  ///< the text from the fault to the end of its line, to find the place in the file
};

/// Reads marked-up text. Term names are compared without regard to ASCII case. Throws MarkupError.
Prose parseProse(std::string_view text, const std::vector<Term>& terms);

/// Index of the term of this name (ASCII case ignored), or terms.size().
std::size_t findTerm(const std::vector<Term>& terms, std::string_view name);

/// The words alone, paragraphs separated by newlines: for searching and for screen readers.
std::string plainText(const Prose& prose);

}  // namespace halfdisk
