// Does the code panel show castRay's source line by line, with the published listing's numbers?
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "app/source_listing.h"
#include "core/estimators.h"
#include "core/recorder.h"

using namespace halfdisk;

namespace {

std::set<int> numbersOf(const Listing& listing) {
    std::set<int> numbers;
    for (const ListingLine& line : listing)
        if (line.number > 0) numbers.insert(line.number);
    return numbers;
}

}  // namespace

TEST_CASE("a line's number is taken off, the observer is left out, comments stay at the end of their line") {
    const Listing listing = parseListing(
        "before();\n// [listing]\ntemplate <class Observer>\nint CastRay<Observer>::f(int a) {  // 001\n"
        "    see.enter(a);\n    if (!a) return 0;  // nothing there\n    long x = g(a,\n               b);  "
        "// 002\n"
        "    // a comment;\n    return x;\n}  // 003\n// [end]\nafter();\n");
    std::vector<std::pair<int, std::string>> words;
    for (const ListingLine& line : listing) {
        const std::size_t begin = line.text.find_first_not_of(' ');
        words.emplace_back(line.number, line.text.substr(std::min(begin, line.text.size())));
    }
    // A statement over two lines is shown as one or as two; either way its number is there once.
    const auto has = [&](int number, const char* text) {
        return std::count(words.begin(), words.end(), std::pair<int, std::string>(number, text)) == 1;
    };
    CHECK(has(1, "int f(int a) {"));
    CHECK(has(0, "if (!a) return 0;  // nothing there"));
    CHECK((has(2, "long x = g(a, b);") || (has(0, "long x = g(a,") && has(2, "b);"))));
    CHECK(has(0, "// a comment;"));
    CHECK(has(0, "return x;"));
    CHECK(has(3, "}"));
}

TEST_CASE("no code is hidden behind a comment") {
    const Listings listings = loadListings();
    for (const Listing* listing : {&listings.corrected, &listings.asPrinted})
        for (const ListingLine& line : *listing) {
            const std::size_t comment = line.text.find("//");
            if (line.comment || comment == std::string::npos) continue;
            CAPTURE(line.text);
            CHECK(line.text.find_first_of(";{}", comment) == std::string::npos);
        }
}

TEST_CASE("both listings show every line that the recorder can light") {
    const Listings listings = loadListings();
    for (const EventKind kind :
         {EventKind::meet, EventKind::enter, EventKind::light, EventKind::sample, EventKind::direction,
          EventKind::arrival, EventKind::accumulate, EventKind::average, EventKind::leave}) {
        CAPTURE(static_cast<int>(kind));
        CHECK(numbersOf(listings.corrected).count(listingLine(kind)) == 1);
        CHECK(numbersOf(listings.asPrinted).count(listingLine(kind)) == 1);
    }
}

TEST_CASE("of an estimator's source the marked parts are shown, without what serves the recorder") {
    const Listing listing = parseRunListing(
        "core/a.cpp",
        "hidden();\n    // [listing]\n    // one path\n    void f(int a, PathRecorder* see) {\n"
        "        PathRecorder* const see = record;\n        g(a,\n          see);\n"
        "        if (see)\n            see->fly(a,\n                     b);\n        walk(watched);\n    }\n"
        "    // [end]\nhidden();\n// [listing]\nint x;\n// [end]\n");
    std::vector<std::pair<int, std::string>> lines;
    for (const ListingLine& line : listing)
        if (!line.text.empty()) lines.emplace_back(line.source, line.text);
    const std::vector<std::pair<int, std::string>> expected{
        {0, "core/a.cpp"},        {3, "// one path"}, {4, "void f(int a) {"}, {6, "  g(a, see);"},
        {11, "  walk(visitor);"}, {12, "}"},          {16, "int x;"}};
    CHECK(lines == expected);
    CHECK(listing[static_cast<std::size_t>(lineOf(listing, {"/some/where/core/a.cpp", 9}))].source == 6);
    CHECK(lineOf(listing, {"/some/where/core/b.cpp", 9}) == -1);
}

TEST_CASE("each estimator that can be recorded has a listing, and each run a name in the registry") {
    const Listings listings = loadListings();
    std::size_t recorded = 0;
    for (const EstimatorInfo* info : estimators()) recorded += info->recorded ? 1 : 0;
    CHECK(kRuns.size() == recorded + 1);
    for (const Named<Run>& run : kRuns) {
        CAPTURE(run.name);
        REQUIRE(findEstimator(run.name) != nullptr);
        if (run.value == Run::castRay) continue;
        CHECK(findEstimator(run.name)->recorded);
        CHECK(listings.runs[static_cast<std::size_t>(run.value)].size() > 40);
        for (const ListingLine& line : listings.runs[static_cast<std::size_t>(run.value)]) {
            CAPTURE(line.text);
            for (const char* hidden : {"see)", "see->", "see_", "Watched", "watched", "tell"})
                CHECK(line.text.find(hidden) == std::string::npos);
        }
    }
}
