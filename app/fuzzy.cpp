#include "app/fuzzy.h"

#include <algorithm>
#include <limits>

#include "lessons/utf8.h"

namespace halfdisk {
namespace {

constexpr int kLetter = 1, kRun = 10, kWordStart = 8, kTextStart = 4, kInOrder = 10, kWholeWord = 12,
              kNone = -1'000'000'000;

struct Letter {
    char32_t folded;
    std::size_t offset;  // bytes
    bool startsWord;
};

/// Capitals become small: Latin, Greek and Cyrillic ones.
char32_t folded(char32_t c) {
    const auto isIn = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
    if (isIn(U'A', U'Z') || (isIn(0xC0, 0xDE) && c != 0xD7) || isIn(0x391, 0x3A9) || isIn(0x410, 0x42F))
        return c + 32;
    return c;
}

/// The character at the start of `text`, `length` bytes of UTF-8; of others a value that no text has.
char32_t decoded(std::string_view text, std::size_t length) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (length == 0) return 0x110000u + byte(0);
    if (length == 1) return byte(0);
    char32_t value = byte(0) & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) value = (value << 6) | (byte(i) & 0x3Fu);
    return value;
}

bool isGap(char32_t c) {
    return c < U'0' || (c > U'9' && c < U'A') || (c > U'Z' && c < U'a') || (c > U'z' && c < 0x80) ||
           c == 0x203A;
}

std::vector<Letter> lettersOf(std::string_view text, std::size_t most) {
    std::vector<Letter> letters;
    letters.reserve(std::min(most, text.size()));
    bool afterGap = true;
    for (std::size_t at = 0; at < text.size() && letters.size() < most;) {
        const std::size_t length = characterLength(text.substr(at));
        const char32_t c = decoded(text.substr(at), length);
        letters.push_back({folded(c), at, afterGap && !isGap(c)});
        afterGap = isGap(c);
        at += std::max<std::size_t>(length, 1);
    }
    return letters;
}

/// Whether all words occur one after the other, letter by letter.
bool isInOrder(const FuzzyQuery& query, const std::vector<Letter>& text) {
    auto at = text.begin();
    for (const std::u32string& word : query.words)
        for (const char32_t c : word) {
            at = std::find_if(at, text.end(), [c](const Letter& letter) { return letter.folded == c; });
            if (at == text.end()) return false;
            ++at;
        }
    return true;
}

/// One word of the query against the text. `places`, if wanted, gets the letters that it meets.
int scoreOfWord(const std::u32string& word, const std::vector<Letter>& text,
                std::vector<std::size_t>* places) {
    const std::size_t count = word.size();
    // Most texts do not have the letters at all.
    std::size_t found = 0;
    for (std::size_t k = 0; k < text.size() && found < count; ++k)
        if (text[k].folded == word[found]) ++found;
    if (found < count) return kNone;

    const std::size_t n = text.size();
    // best[i * n + k]: of the word's first i + 1 letters, when the last of them is text[k].
    std::vector<int> best(count * n, kNone);
    std::vector<std::size_t> from(places ? count * n : 0);
    for (std::size_t i = 0; i < count; ++i) {
        int before = kNone;  // the best of the letter before, anywhere to the left
        std::size_t beforeAt = 0;
        for (std::size_t k = 0; k < n; ++k) {
            if (i > 0 && k > 0 && best[(i - 1) * n + k - 1] > before) {
                before = best[(i - 1) * n + k - 1];
                beforeAt = k - 1;
            }
            if (text[k].folded != word[i]) continue;
            int score = 0;
            std::size_t origin = 0;
            if (i > 0) {
                if (before == kNone) continue;
                const int run = best[(i - 1) * n + k - 1];
                const bool isRun = run != kNone && run + kRun >= before;
                score = isRun ? run + kRun : before;
                origin = isRun ? k - 1 : beforeAt;
            }
            score += kLetter + (text[k].startsWord ? kWordStart : 0) + (k == 0 ? kTextStart : 0);
            best[i * n + k] = score;
            if (places) from[i * n + k] = origin;
        }
    }
    const auto last = best.begin() + static_cast<std::ptrdiff_t>((count - 1) * n);
    const auto most = std::max_element(last, best.end());
    if (places) {
        std::size_t k = static_cast<std::size_t>(most - last);
        for (std::size_t i = count; i-- > 0; k = from[i * n + k]) places->push_back(text[k].offset);
    }
    return *most;
}

/// Whether it stands in the text as a word by itself.
bool isWholeWord(const std::u32string& word, const std::vector<Letter>& text) {
    const auto same = [](const Letter& letter, char32_t c) { return letter.folded == c; };
    auto at = text.begin();
    while ((at = std::search(at, text.end(), word.begin(), word.end(), same)) != text.end()) {
        const auto end = at + static_cast<std::ptrdiff_t>(word.size());
        if (at->startsWord && (end == text.end() || isGap(end->folded))) return true;
        ++at;
    }
    return false;
}

std::optional<int> match(const FuzzyQuery& query, std::string_view text, std::vector<std::size_t>* places) {
    const std::vector<Letter> letters = lettersOf(text, kMostFuzzyLetters);
    if (query.letters > letters.size()) return std::nullopt;
    int score = 0;
    for (const std::u32string& word : query.words) {
        const int one = scoreOfWord(word, letters, places);
        if (one == kNone) return std::nullopt;
        score += one + (isWholeWord(word, letters) ? kWholeWord : 0);
    }
    if (query.words.size() > 1 && isInOrder(query, letters)) score += kInOrder;
    return score;
}

}  // namespace

FuzzyQuery::FuzzyQuery(std::string_view text) {
    bool inWord = false;
    for (const Letter& letter : lettersOf(text, text.size())) {
        const bool blank = letter.folded == U' ';
        if (!blank && !inWord) words.emplace_back();
        inWord = !blank;
        if (blank) continue;
        words.back() += letter.folded;
        ++letters;
    }
}

std::optional<int> fuzzyScore(const FuzzyQuery& query, std::string_view text) {
    return match(query, text, nullptr);
}

std::vector<std::size_t> fuzzyPlaces(const FuzzyQuery& query, std::string_view text) {
    std::vector<std::size_t> places;
    if (!match(query, text, &places)) return {};
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

}  // namespace halfdisk
