// Does marked-up text become the paragraphs and spans that a teacher means?
#include "lessons/prose.h"

#include <doctest/doctest.h>

using namespace halfdisk;

namespace {

const std::vector<Term> kTerms{{"radiance", "power per ..."}, {"half-disk", "what P sees"}};

Span plain(std::string text) {
    return {SpanStyle::plain, std::move(text), 0};
}

std::vector<Span> spans(std::string_view text) {
    const Prose prose = parseProse(text, kTerms);
    REQUIRE(prose.size() == 1);
    CHECK(prose[0].kind == ParagraphKind::text);
    return prose[0].spans;
}

}  // namespace

TEST_CASE("paragraphs are separated by blank lines and their lines are joined") {
    CHECK(parseProse("", kTerms).empty());
    CHECK(parseProse(" \n\n \t\r\n", kTerms).empty());
    const Prose prose = parseProse("\n one\r\n  two  three \n \t \n\n\nfour", kTerms);
    REQUIRE(prose.size() == 2);
    CHECK(prose[0].spans == std::vector<Span>{plain("one two three")});
    CHECK(prose[1].spans == std::vector<Span>{plain("four")});
    CHECK(plainText(prose) == "one two three\nfour");
}

TEST_CASE("emphasis, strong words and code are told apart") {
    CHECK(spans("a **b c** d *e* `f*[` g") == std::vector<Span>{plain("a "),
                                                                {SpanStyle::strong, "b c", 0},
                                                                plain(" d "),
                                                                {SpanStyle::emphasis, "e", 0},
                                                                plain(" "),
                                                                {SpanStyle::code, "f*[", 0},
                                                                plain(" g")});
    CHECK(spans("**b\nc**") == std::vector<Span>{{SpanStyle::strong, "b c", 0}});
    CHECK(spans("*a**b*") == std::vector<Span>{{SpanStyle::emphasis, "a", 0}, {SpanStyle::emphasis, "b", 0}});
}

TEST_CASE("terms are found whatever their case, also under other words") {
    CHECK(spans("[Radiance]") == std::vector<Span>{{SpanStyle::term, "Radiance", 0}});
    CHECK(spans("the [Half-Disk], [its\n light|radiance]!") ==
          std::vector<Span>{plain("the "),
                            {SpanStyle::term, "Half-Disk", 1},
                            plain(", "),
                            {SpanStyle::term, "its light", 0},
                            plain("!")});
}

TEST_CASE("a backslash takes away the meaning, and lone marks have none") {
    CHECK(spans(R"(\*a\* \[b\] \`c\` \\ \| \d)") == std::vector<Span>{plain(R"(*a* [b] `c` \ | \d)")});
    CHECK(spans("2 * 3 ** 4 ] | *") == std::vector<Span>{plain("2 * 3 ** 4 ] | *")});
    CHECK(spans(R"(`a\`b`)") == std::vector<Span>{{SpanStyle::code, "a`b", 0}});
    CHECK(spans(R"([a\|b\]|radiance])") == std::vector<Span>{{SpanStyle::term, "a|b]", 0}});
    CHECK(spans("ends with \\") == std::vector<Span>{plain("ends with \\")});
}

TEST_CASE("a formula stands alone and as written") {
    const Prose prose = parseProse("So\n$ E = \u222b L cos\u03b8 d\u03b8 * [x] \\\nand\n\\$ 5\n$5", kTerms);
    REQUIRE(prose.size() == 3);
    CHECK(prose[0].spans == std::vector<Span>{plain("So")});
    CHECK(prose[1].kind == ParagraphKind::formula);
    CHECK(prose[1].spans == std::vector<Span>{plain("E = \u222b L cos\u03b8 d\u03b8 * [x] \\")});
    CHECK(prose[2].spans == std::vector<Span>{plain("and $ 5 $5")});
}

TEST_CASE("markup that cannot be meant is refused and pointed at") {
    const auto refused = [](std::string_view text, const char* said, std::string_view snippet) {
        CAPTURE(text);
        try {
            parseProse(text, kTerms);
            FAIL_CHECK("accepted");
        } catch (const MarkupError& error) {
            CHECK(std::string(error.what()).find(said) != std::string::npos);
            CHECK(error.snippet == snippet);
        }
    };
    refused("a **b", "** is never closed", "**b");
    refused("a *b\n\nc*", "* is never closed", "*b");
    refused("x\na `b\nc", "` is never closed", "`b");
    refused("a [b", "[ is never closed", "[b");
    refused("a [radiant] c", "did you mean \"radiance\"?", "[radiant] c");
    refused("[]", "names no term", "[]");
    refused("[|radiance]", "no words", "[|radiance]");
    refused("a `` b", "nothing between", "`` b");
    refused("**a *b* c**", "does not nest", "**a *b* c**");
    refused("*see [radiance]*", "does not nest", "*see [radiance]*");
}
