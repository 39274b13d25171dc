// Does damage to a good file, however it comes about, end in anything but an InputError?
#include <doctest/doctest.h>

#include <filesystem>
#include <random>
#include <vector>

#include "loader_property.h"
#include "temp_folder.h"

namespace {

constexpr int kMutants = 4000;

/// One to four random edits: flipped, removed, doubled or inserted bytes, and swapped pieces of TOML.
std::string damaged(std::string text, std::mt19937& random) {
    constexpr std::string_view kPieces[] = {"[",     "]",    "[[",         "\"",   "'''", "=", "nan", "-inf",
                                            "1e999", "0",    "-1",         "\n",   "\\",  ".", "{",   "}",
                                            "#",     "\xff", "1000000000", "true", "in",  ":", "*"};
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
        const std::size_t at = below(text.size());
        const std::size_t length = std::min(text.size() - at, 1 + below(20));
        switch (below(5)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(below(text.size()), text.substr(at, length));
                break;
            case 3:
                text.insert(at, kPieces[below(std::size(kPieces))]);
                break;
            default:
                text.replace(at, length, kPieces[below(std::size(kPieces))]);
                break;
        }
    }
    return text;
}

template <class Check>
void checkMutants(const std::string& good, const Check& check) {
    REQUIRE(check(good));
    std::mt19937 random(1);
    int accepted = 0;
    for (int i = 0; i < kMutants; ++i) accepted += check(damaged(good, random));
    // Were all refused at the first byte, or none, the test would say nothing.
    CHECK(accepted > kMutants / 100);
    CHECK(accepted < kMutants / 2);
}

}  // namespace

TEST_CASE("damaged scenes are refused or sound") {
    const std::filesystem::path corpus = std::filesystem::path(LOADER_DATA) / "../corpus/scene";
    checkMutants(readAll(corpus / "everything.toml"), checkSceneText);
    checkMutants(readAll(corpus / "corner.toml"), checkSceneText);
    checkMutants(readAll(corpus / "optics.toml"), checkSceneText);
}

TEST_CASE("damaged lessons are refused or sound") {
    const std::filesystem::path corpus = std::filesystem::path(LOADER_DATA) / "../corpus/lesson";
    checkMutants(readAll(corpus / "sample.toml"), checkLessonText);
}
