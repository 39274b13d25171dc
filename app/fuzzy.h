// How well do a few letters fit a text? Typed quickly, with letters left out: "gth" finds "Gather the light".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfdisk {

/// What is looked for: words, in small letters.
struct FuzzyQuery {
    std::vector<std::u32string> words;
    std::size_t letters = 0;  ///< of all words

    FuzzyQuery() = default;
    FuzzyQuery(std::string_view text);                                           // NOLINT: a text is a query
    FuzzyQuery(const std::string& text) : FuzzyQuery(std::string_view(text)) {}  // NOLINT
    FuzzyQuery(const char* text) : FuzzyQuery(std::string_view(text)) {}         // NOLINT
};

/// Larger is better: starts of words and runs of letters count most. Each word of the query must occur in the
/// text, its letters in their order, others between them; case does not matter, and words in their order are
/// better than others. Nothing if one does not occur. An empty query fits all texts, with 0. Bytes that are
/// no UTF-8 fit nothing but themselves. Of a text the first kMostFuzzyLetters letters are looked at.
std::optional<int> fuzzyScore(const FuzzyQuery& query, std::string_view text);
inline constexpr std::size_t kMostFuzzyLetters = 400;

/// Offsets of the characters of `text` (bytes, ascending) that the letters of the query have met.
std::vector<std::size_t> fuzzyPlaces(const FuzzyQuery& query, std::string_view text);

}  // namespace halfdisk
