// Which of the allowed names did the writer mean?
#include "lessons/suggestions.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/utf8.h"

namespace halfdisk {
namespace {

constexpr std::size_t kLongestCompared = 64;  // the distance costs the product of the lengths
constexpr std::size_t kMostListed = 12;

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
    // Three rows of the table of distances between the prefixes of a and of b.
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        beforeLast = last;
        last = row;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0u : 1u)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string_view nearestName(std::string_view name, const std::vector<std::string_view>& candidates) {
    if (name.size() > kLongestCompared) return {};
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        // At least the difference of the lengths must be inserted.
        if (std::max(candidate.size(), name.size()) - std::min(candidate.size(), name.size()) >= least)
            continue;
        const std::size_t distance = editDistance(name, candidate);
        if (distance < least && distance < candidate.size()) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string expectedOneOf(std::string_view name, const std::vector<std::string_view>& candidates) {
    if (candidates.empty()) return "expected nothing here";
    std::string text = candidates.size() == 1 ? "expected " : "expected one of ";
    const std::size_t listed = std::min(candidates.size(), kMostListed);
    for (std::size_t i = 0; i < listed; ++i) {
        if (i > 0) text += i + 1 == candidates.size() ? " or " : ", ";
        text += fmt::format("\"{}\"", excerpt(candidates[i]));
    }
    if (listed < candidates.size()) text += fmt::format(" and {} more", candidates.size() - listed);
    const std::string_view nearest = nearestName(name, candidates);
    if (!nearest.empty() && excerpt(nearest) != excerpt(name))
        text += fmt::format("; did you mean \"{}\"?", nearest);
    return text;
}

}  // namespace halfdisk
