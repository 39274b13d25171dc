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

/// Takes the first line off the text.
std::string nextLine(std::string_view& source) {
    const std::size_t end = source.find('\n');
    std::string line(source.substr(0, end));
    source.remove_prefix(end == std::string_view::npos ? source.size() : end + 1);
    return line;
}

bool startsWithOneOf(std::string_view words, std::initializer_list<std::string_view> starts) {
    return std::any_of(starts.begin(), starts.end(),
                       [&](std::string_view start) { return words.starts_with(start); });
}

/// Adds the line, or lengthens the last one if its statement goes on.
void append(Listing& listing, ListingLine line, std::size_t indent) {
    std::string& text = line.text;
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    line.comment = trimmed(text).substr(0, 2) == "//";
    if (!listing.empty() && listing.back().file == line.file && isUnfinished(listing.back())) {
        listing.back().text.append(" ").append(trimmed(text));
        listing.back().number = std::max(listing.back().number, line.number);
        return;
    }
    const std::size_t spaces = std::min(text.find_first_not_of(' '), text.size());
    text = text.substr((spaces + std::min(spaces, indent)) / 2);
    listing.push_back(std::move(line));
}

}  // namespace

Listing parseListing(std::string_view source) {
    Listing listing;
    bool inside = false;
    while (!source.empty()) {
        ListingLine line;
        line.text = nextLine(source);
        const std::string_view words = trimmed(line.text);
        if (words == "// [end]") break;
        if (words == "// [listing]") {
            inside = true;
            continue;
        }
        if (!inside || startsWithOneOf(words, {"see.", "template "})) continue;
        removeAll(line.text, "CastRay<Observer>::");
        removeAll(line.text, "AsPrinted<Observer>::");
        removeAll(line.text, " && see.keepGoing()");
        line.number = takeNumber(line.text);
        append(listing, std::move(line), 0);
    }
    return listing;
}

Listing parseRunListing(std::string_view file, std::string_view source) {
    Listing listing{{.number = 0, .text = std::string(file), .comment = true, .file = file, .source = 0}};
    bool inside = false, leftOut = false;
    std::size_t indent = 0;  // of the part, which begins at the left edge
    for (int number = 1; !source.empty(); ++number) {
        ListingLine line{.number = 0, .text = nextLine(source), .file = file, .source = number};
        const std::string_view words = trimmed(line.text);
        if (words == "// [listing]") indent = line.text.find("//");
        if (words == "// [listing]" || words == "// [end]") {
            inside = words == "// [listing]";
            if (!inside) listing.push_back({.number = 0, .text = "", .file = file, .source = number});
            continue;
        }
        const bool begins =
            startsWithOneOf(words, {"if (see", "PathRecorder* const see", "Watched ", "throwIfStopped(",
                                    "template ", "tell(", "const Joint joint = "});
        if (!inside || leftOut || begins) {
            leftOut = inside && (leftOut || begins) && !words.ends_with(';') && !words.ends_with('>');
            continue;
        }
        removeAll(line.text, ", PathRecorder* see");
        for (const auto& [from, to] : {std::pair<std::string_view, std::string_view>{"watched", "visitor"},
                                       {"Watched", "Visitor"},
                                       {", see)", ")"},
                                       {", problem_.record, ", ", "},
                                       {"return tellBlocked(joint)", "return"}})
            for (auto at = line.text.find(from); at != std::string::npos; at = line.text.find(from))
                line.text.replace(at, from.size(), to);
        append(listing, std::move(line), indent);
    }
    return listing;
}

std::string_view sourceOf(std::string_view file) {
    for (const EmbeddedSource& source : embeddedSources())
        if (source.file == file) return source.text;
    return {};
}

Listings loadListings() {
    Listings listings{
        parseListing(sourceOf("core/cast_ray.h")), parseListing(sourceOf("core/as_printed.h")), {}};
    const auto joined = [](std::initializer_list<std::string_view> files) {
        Listing all;
        for (const std::string_view file : files) {
            Listing one = parseRunListing(file, sourceOf(file));
            all.insert(all.end(), one.begin(), one.end());
        }
        return all;
    };
    const auto of = [&](Run run) -> Listing& { return listings.runs[static_cast<std::size_t>(run)]; };
    of(Run::path) = joined({"core/estimators/path.cpp", "core/walk.h"});
    of(Run::light) = joined({"core/estimators/light_paths.h", "core/walk.h", "core/estimators/light.cpp"});
    of(Run::photonMap) =
        joined({"core/estimators/light_paths.h", "core/walk.h", "core/estimators/photon_maps.cpp",
                "core/estimators/photon_gather.cpp", "core/estimators/look.h", "core/estimators/gather.h"});
    of(Run::bidirectional) = joined({"core/estimators/bidirectional_join.cpp", "core/walk.h"});
    return listings;
}

int lineOf(const Listing& listing, const SourceLine& where) {
    int found = -1;
    for (std::size_t i = 0; i < listing.size(); ++i) {
        const ListingLine& line = listing[i];
        if (line.source > 0 && !line.text.empty() && line.source <= where.line &&
            where.file.ends_with(line.file))
            found = static_cast<int>(i);
    }
    return found;
}

}  // namespace halfdisk
