// Are characters counted, names compared and texts quoted as a person would?
#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "lessons/suggestions.h"
#include "lessons/toml_hazards.h"
#include "lessons/toml_shield.h"
#include "lessons/utf8.h"

using namespace halfdisk;

TEST_CASE("UTF-8 is checked by the table of well-formed sequences") {
    for (const char* good : {"", "a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                             "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "\u03b8 \u222b \U0001F600"})
        CHECK_FALSE(firstInvalidUtf8(good).has_value());
    for (const char* bad :
         {"ab\x80", "ab\xc1\xbf", "ab\xe0\x9f\xbf", "ab\xed\xa0\x80", "ab\xf0\x8f\xbf\xbf",
          "ab\xf4\x90\x80\x80", "ab\xf5\x80\x80\x80", "ab\xc2", "ab\xe2\x82", "ab\xe2\x82z", "ab\xff"})
        CHECK(firstInvalidUtf8(bad) == std::size_t{2});
}

TEST_CASE("places count characters and lines from 1") {
    const std::string_view text = "\u00e9a\n\u222bb\n";
    CHECK(positionOf(text, 0) == TextPosition{1, 1});
    CHECK(positionOf(text, 2) == TextPosition{1, 2});
    CHECK(positionOf(text, 4) == TextPosition{2, 1});
    CHECK(positionOf(text, 7) == TextPosition{2, 2});
    CHECK(positionOf(text, text.size()) == TextPosition{3, 1});
}

TEST_CASE("quotes are short and hold no control characters") {
    CHECK(excerpt("a\nb\x1b[0m", 60) == "a?b?[0m");
    CHECK(excerpt("\u00e9\u00e9\u00e9", 2) == "\u00e9\u00e9...");
    CHECK(excerpt("\u00e9\u00e9", 2) == "\u00e9\u00e9");
}

TEST_CASE("a slip of the pen is recognised, a different word is not") {
    CHECK(editDistance("radius", "raduis") == 1);
    CHECK(editDistance("", "abc") == 3);
    CHECK(editDistance("Kitten", "sitting") == 3);
    CHECK(nearestName("raduis", {"center", "radius"}) == "radius");
    CHECK(nearestName("color", {"albedo", "type"}).empty());
    CHECK(nearestName("x", {"a", "b"}).empty());
    CHECK(expectedOneOf("b", {"a"}) == "expected \"a\"");
    CHECK(expectedOneOf("zzz", {"a", "b", "c"}) == "expected one of \"a\", \"b\" or \"c\"");
}

TEST_CASE("only the dots of keys count as nesting, and only strings and comments go beyond ASCII") {
    const auto offset = [](const std::string& text) {
        const auto hazard = firstHazard(text);
        return hazard ? std::optional(hazard->offset) : std::nullopt;
    };
    const std::string sixteen = "a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p", seventeen = sixteen + ".q";
    CHECK_FALSE(offset(sixteen + " = 1").has_value());
    CHECK(offset(seventeen + " = 1") == sixteen.size() + 1);
    CHECK(offset("\xef\xbb\xbf" + seventeen) == sixteen.size() + 4);
    for (const std::string& word : {seventeen, std::string("\u03b8")}) {
        for (const char* around : {R"(a = "@")", R"(a = '@')", R"(# @)", "a = \"\"\"\n@\\\"\"\"\"\"",
                                   "a = '''\n@'''''", R"(a = "\"@")", R"("@" = 1)", R"(a = '''\n'@''@''')",
                                   R"(a = """@"""" # @)", R"(a = '\' # @)"}) {
            std::string text(around);
            for (std::size_t at; (at = text.find('@')) != std::string::npos;) text.replace(at, 1, word);
            CAPTURE(text);
            CHECK_FALSE(offset(text).has_value());
        }
        for (const char* before : {"", "a = \"\"\"x\"\"\"\n", "a = '\\'\n", "a = \"\"\n",
                                   "a = \"\"\"\"\"\"\n", "# '\n", "a = ''''''''\n"}) {
            CAPTURE(before);
            CHECK(offset(before + word).has_value());
        }
    }
}

TEST_CASE("shielded text holds nothing between ASCII and plane 16 and comes back as it was") {
    const std::string text =
        "\xef\xbb\xbf"
        "a\u0080\u00e9\u07ff\u0800\u03b8\ufeff\ud7ff\ue000\uffff\U00010000\U000fffff";
    CHECK(unshielded(shielded(text)) == text);
    CHECK(shielded("\u03b8") == "\U001003b8");
    CHECK(shielded("\uffff") == "\U0010ffff");
    CHECK(characterCount(shielded(text)) == characterCount(text));
    CHECK_FALSE(firstUnshieldable(text).has_value());
    CHECK(firstUnshieldable("a\U00100000") == std::size_t{1});
    CHECK(firstUnshieldable("\"\\U001003b8\"") == std::size_t{1});
}
