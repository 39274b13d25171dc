#include "app/source_listing.h"

#include <algorithm>
#include <cctype>

#include "app/embedded_sources.h"

namespace halfdisk {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

void removeAll(std::string& text, std::string_view part) {
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part))
        text.erase(at, part.size());
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Takes a trailing "// 017" off the line and returns 17; 0 if there is none.
int takeNumber(std::string& text) {
    const std::string_view all = trimmed(text);
    constexpr std::size_t kTag = 6;
    if (all.size() < kTag) return 0;
    const std::string_view tag = all.substr(all.size() - kTag);
    if (tag.substr(0, 3) != "// " || !isDigit(tag[3]) || !isDigit(tag[4]) || !isDigit(tag[5])) return 0;
    const int number = (tag[3] - '0') * 100 + (tag[4] - '0') * 10 + (tag[5] - '0');
    text.erase(text.rfind(tag));
    return number;
}

/// Whether the statement goes on in the next line of the source. What a trailing comment says does not count.
bool isUnfinished(const ListingLine& line) {
    const std::string_view code = trimmed(std::string_view(line.text).substr(0, line.text.find("//")));
    if (line.comment || code.empty()) return false;
    const char last = code.back();
    return last != ';' && last != '{' && last != '}';
}

}  // namespace

Listing parseListing(std::string_view source) {
    Listing listing;
    bool inside = false;
    while (!source.empty()) {
        const std::size_t end = source.find('\n');
        std::string text(source.substr(0, end));
        source.remove_prefix(end == std::string_view::npos ? source.size() : end + 1);
        const std::string_view words = trimmed(text);
        if (words == "// [end]") break;
        if (words == "// [listing]") {
            inside = true;
            continue;
        }
        if (!inside || words.substr(0, 4) == "see." || words.substr(0, 9) == "template ") continue;
        removeAll(text, "CastRay<Observer>::");
        removeAll(text, "AsPrinted<Observer>::");
        removeAll(text, " && see.keepGoing()");
        ListingLine line;
        line.number = takeNumber(text);
        while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
        line.comment = trimmed(text).substr(0, 2) == "//";
        if (!listing.empty() && isUnfinished(listing.back())) {
            listing.back().text.append(" ").append(trimmed(text));
            listing.back().number = std::max(listing.back().number, line.number);
            continue;
        }
        const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
        line.text = text.substr(indent / 2);
        listing.push_back(std::move(line));
    }
    return listing;
}

Listings loadListings() {
    return {parseListing(castRaySource()), parseListing(asPrintedSource())};
}

}  // namespace halfdisk
