// Does a drawing say what the pen drew, in few stable bytes?
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/csv_text.h"
#include "app/svg_drawing.h"
#include "app/words_page.h"
#include "app/xml_text.h"
#include "file_reading.h"

using namespace halfdisk;

namespace {

constexpr ImU32 kBlack = IM_COL32(0, 0, 0, 255), kFaint = IM_COL32(255, 0, 128, 51);

SvgDrawing drawing() {
    return SvgDrawing("plot", {10, 20}, {110, 70}, IM_COL32(255, 255, 255, 255));
}

bool holds(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

std::size_t count(const XmlFile& xml, std::string_view element) {
    return static_cast<std::size_t>(std::count(xml.elements.begin(), xml.elements.end(), element));
}

}  // namespace

TEST_CASE("svg: places count from the drawing's corner, in two decimals, without negative zeros") {
    SvgDrawing svg = drawing();
    svg.line({10.0f, 19.999f}, {110.126f, 20.5f}, kBlack, 0.5f);
    const std::string file = svg.svg("title", "words");
    CHECK(holds(file, "width=\"100\" height=\"50\" viewBox=\"0 0 100 50\""));
    CHECK(holds(file, "d=\"M0 0L100.13 0.5\""));
    CHECK(holds(file, "stroke-width=\"1\""));  // as the screen draws thinner ones
}

TEST_CASE("svg: opaque lines of one style are one path; those that let others through are not") {
    SvgDrawing svg = drawing();
    for (const float y : {21.0f, 22.0f, 23.0f}) svg.line({10, y}, {20, y}, kBlack, 2);
    for (const float y : {21.0f, 22.0f}) svg.line({10, y}, {20, y}, kFaint, 2);
    svg.line({10, 30}, {20, 30}, kBlack, 3);
    const XmlFile xml = readXml(svg.svg("", ""));
    REQUIRE_MESSAGE(xml.fault.empty(), xml.fault);
    CHECK(count(xml, "path") == 4);
    CHECK(holds(svg.svg("", ""), "stroke=\"#ff0080\" stroke-opacity=\"0.2\""));
}

TEST_CASE("svg: what cannot be seen is left out") {
    SvgDrawing svg = drawing();
    svg.line({10, 20}, {30, 40}, IM_COL32(0, 0, 0, 0), 1);
    svg.rectFilled({10, 20}, {30, 40}, IM_COL32(9, 9, 9, 0), 0);
    svg.text({10, 20}, 10, IM_COL32(9, 9, 9, 0), "words", {});
    svg.text({10, 20}, 10, kBlack, "", {});
    CHECK(readXml(svg.svg("", "")).elements.size() == 4);  // the root, its title and words, and the ground
}

TEST_CASE("svg: clips nest, are named once, and are closed even if somebody forgets") {
    SvgDrawing svg = drawing();
    svg.pushClip({10, 20}, {60, 40});
    svg.pushClip({20, 20}, {60, 40});
    svg.circleFilled({30, 30}, 5, kBlack);
    svg.popClip();
    const XmlFile xml = readXml(svg.svg("", ""));
    REQUIRE_MESSAGE(xml.fault.empty(), xml.fault);
    CHECK(xml.uses == std::vector<std::string>{"plot-clip1", "plot-clip2"});
    svg.popClip();
    svg.popClip();  // one too many
    CHECK(readXml(svg.svg("", "")).fault.empty());
}

TEST_CASE("svg: words keep their letters, whatever they are") {
    SvgDrawing svg = drawing();
    const std::string words = "a < b & \"c\" > d  \u03b8 \u2265";
    svg.text({10, 30}, 80, kBlack, words, {nullptr, "Inter & Sons", true, false, 16.5f, 12.0f});
    const std::string broken("x\x01y\xff z");
    svg.text({10, 50}, 80, kBlack, broken, {});
    const XmlFile xml = readXml(svg.svg(words, words));
    REQUIRE_MESSAGE(xml.fault.empty(), xml.fault);
    CHECK(xml.texts == std::vector<std::string>{words, "x\uFFFDy\uFFFD z"});
    CHECK(xml.title == words);
    CHECK(xml.description == words);
    CHECK(holds(svg.svg("", ""), "textLength=\"80\""));
    CHECK(holds(svg.svg("", ""), "font-weight=\"bold\""));
}

TEST_CASE("svg: cells are a picture in the text, whatever their number of bytes") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    SvgDrawing svg = drawing();
    const std::vector<std::uint32_t> colors{0xff000000u, 0xffffffffu, 0xff0000ffu};
    svg.cells({10, 20}, {40, 30}, colors, 3, 0.5f);
    const std::string file = svg.svg("", "");
    CHECK(readXml(file).fault.empty());
    CHECK(holds(file, "<image x=\"0\" y=\"0\" width=\"30\" height=\"10\""));
    CHECK(holds(file, "opacity=\"0.5\""));
    CHECK(holds(file, "data:image/png;base64,iVBORw0KGgo"));
}

TEST_CASE("svg: a premultiplied picture is embedded with its own colours") {
    SvgDrawing svg = drawing();
    svg.picture({20, 30}, {60, 50}, {2, 1, {100, 0, 50, 128, 0, 0, 0, 0}});
    const std::string file = svg.svg("", "");
    CHECK(readXml(file).fault.empty());
    CHECK(holds(file, "<image x=\"10\" y=\"10\" width=\"40\" height=\"20\""));
    CHECK_FALSE(holds(file, "pixelated"));
    const std::string expected = encodePng({2, 1, {199, 0, 100, 128, 0, 0, 0, 0}});
    CHECK(holds(file, "base64," + base64(expected)));
}

TEST_CASE("csv: quotes where they are needed, numbers with every bit, nothing for what is not finite") {
    CsvText table{"name", "value (W/m)"};
    table.cell("a, \"b\"\nc").cell(0.1).endRow();
    table.cell("plain").cell(std::nan("")).endRow();
    table.cell(Rgb(1.0, -0.0, 1e-300)).empty(2).endRow();
    CHECK(table.text() == "name,value (W/m)\n\"a, \"\"b\"\"\nc\",0.1\nplain,\n1,0,1e-300,,\n");
    CHECK(readCsv(table.text())[1][0] == "a, \"b\"\nc");
}

TEST_CASE("words: lines break between words at 100 columns, later ones of a list are indented") {
    WordsPage page;
    std::string many;
    for (int i = 0; i < 40; ++i) many += "\u03b8\u03b8\u03b8\u03b8 ";
    page.item(many);
    CHECK(page.text().substr(0, 2) == "- ");
    CHECK(holds(page.text(), "\n  \u03b8"));
    page.paragraph("one\ntwo");
    CHECK(holds(page.text(), "\none\ntwo\n"));
    page.paragraph(std::string(150, 'x'));
    CHECK(holds(page.text(), "\n" + std::string(150, 'x') + "\n"));
}
