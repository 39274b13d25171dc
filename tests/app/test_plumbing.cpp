// Do pictures, fonts, colours, widgets and scripted input work, without any OpenGL?
#include <doctest/doctest.h>
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/embedded_sources.h"
#include "app/line_breaks.h"
#include "app/png_image.h"
#include "app/theme.h"
#include "demo_panel.h"
#include "driver.h"

using namespace halfdisk;

namespace {

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x * 7, y * 5, x * y, 255 - x})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
    return image;
}

/// A demo panel on a host without GL, and the driver for both.
struct Rig {
    std::unique_ptr<HeadlessHost> host = HeadlessHost::withoutGl(1000, 800);
    DemoPanel panel;
    Driver driver{*host, panel.registry, [this] { panel.draw(host->fonts()); }};
};

std::string fileText(const char* path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("a picture survives being written as PNG and read back") {
    const Image image = gradient(37, 23);
    CHECK(decodePng(encodePng(image)) == image);

    const auto path =
        std::filesystem::temp_directory_path() / ("halfdisk plumbing " + std::to_string(::getpid()) + ".png");
    writePng(path, image);
    CHECK(readPng(path) == image);
    std::filesystem::remove(path);
    CHECK_THROWS_WITH_AS(readPng(path), doctest::Contains(path.filename().string().c_str()),
                         std::runtime_error);
}

TEST_CASE("a broken PNG or picture is refused with a reason") {
    const std::string bytes = encodePng(gradient(16, 16));
    CHECK_THROWS_WITH_AS(decodePng("hello"), doctest::Contains("not a PNG"), std::runtime_error);
    CHECK_THROWS_WITH_AS(decodePng(""), doctest::Contains("not a PNG"), std::runtime_error);
    CHECK_THROWS_AS(decodePng(std::string_view(bytes).substr(0, bytes.size() / 2)), std::runtime_error);
    Image tooShort = gradient(4, 4);
    tooShort.rgba.pop_back();
    CHECK_THROWS_AS(encodePng(tooShort), std::invalid_argument);
}

TEST_CASE("comparing pictures counts the pixels beyond the tolerance") {
    const Image a = gradient(40, 30);
    CHECK(compareImages(a, a, 0).outliers == 0);
    Image b = a;
    b.at(11, 7)[1] = static_cast<std::uint8_t>(a.at(11, 7)[1] + 3);
    const ImageComparison result = compareImages(a, b, 2);
    CHECK(result.outliers == 1);
    CHECK(result.largestDifference == 3);
    CHECK(compareImages(a, b, 3).outliers == 0);
    const auto isRed = [&](int x, int y) { return result.picture.at(x, y)[0] != result.picture.at(x, y)[1]; };
    CHECK(isRed(11, 7));
    CHECK_FALSE(isRed(12, 7));
    CHECK_THROWS_WITH_AS(compareImages(a, gradient(40, 31), 2), doctest::Contains("40x31"),
                         std::invalid_argument);
}

TEST_CASE("every text colour can be read on both grounds") {
    CHECK(contrast(IM_COL32_BLACK, IM_COL32_WHITE) == doctest::Approx(21.0));
    const Palette p;
    for (const ImU32 ground : {p.background, p.panel, p.currentLine})
        for (const ImU32 color : {p.ink, p.inkSoft, p.accent, p.error, p.exact, p.estimate})
            CHECK(contrast(color, ground) >= 4.5);
    ImGuiStyle style;
    applyTheme(style, 1.0f, p);
    for (const ImGuiCol knob : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) {
        const ImU32 color = ImGui::ColorConvertFloat4ToU32(style.Colors[knob]);
        CHECK_MESSAGE(contrast(p.ink, color) >= 4.5, "a slider's number is written over its knob");
        for (const ImU32 ground : {p.background, p.panel}) CHECK(contrast(color, ground) >= 3.0);
    }
}

TEST_CASE("lines end at spaces, and never within a number or before its percent sign") {
    const auto host = HeadlessHost::withoutGl(300, 200);
    const std::string words =
        "Tried 8 times: error 33 % \u00b1 0.81 %, 1e-3.5 rays; predicted 34 %. As\npredicted.";
    host->frameWithoutDrawing([&] {
        for (float width = 1.0f; width < 600.0f; width += 1.0f) {
            std::string lines = brokenInto(words, width);
            INFO(lines);
            for (const char* whole : {"33 %", "0.81 %,", "1e-3.5", "34 %."})
                REQUIRE(lines.find(whole) != std::string::npos);
            for (std::size_t begin = 0; begin < lines.size();) {
                const std::size_t end = std::min(lines.find('\n', begin), lines.size());
                const std::string line = lines.substr(begin, end - begin);
                const bool one = endOfWord(line) == line.size();
                REQUIRE((one || ImGui::CalcTextSize(line.c_str()).x <= width + 1.0f));
                begin = end + 1;
            }
            std::replace(lines.begin(), lines.end(), '\n', ' ');
            std::string plain = words;
            std::replace(plain.begin(), plain.end(), '\n', ' ');
            REQUIRE(lines == plain);
        }
        CHECK(brokenInto("a b", 1000.0f) == "a b");
        CHECK(brokenInto("", 10.0f).empty());
    });
}

TEST_CASE("every promised character is in every font") {
    const auto host = HeadlessHost::withoutGl(300, 200);
    CHECK(host->fonts().problem.empty());
    const char32_t* promised =
        U"Az09\u00e9\u222b\u222e\u03a3\u2207\u2202\u221a\u2248\u2208\u2264\u2265\u2260\u00b1\u00b7\u00d7"
        U"\u00b0\u2212"
        U"\u2013\u2014\u201c\u201d\u2018\u2019\u2026\u2192\u2190\u2191\u2193\u27e8\u27e9\u221e\u00bd\u03c0"
        U"\u03b8\u00b2"
        U"\u00b3\u2070\u207f\u2080\u2099\u1d62\u2113\u2713\u2717";
    const Fonts& fonts = host->fonts();
    for (const ImFont* font :
         {fonts.prose, fonts.strong, fonts.emphasis, fonts.code, fonts.title, fonts.formula})
        for (const char32_t* c = promised; *c; ++c) {
            CAPTURE(static_cast<unsigned>(*c));
            CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(*c)) != nullptr);
        }
}

TEST_CASE("missing or broken font files are named and replaced") {
    ImFontAtlas atlas;
    const FontFiles installed = installedFontFiles();
    FontFiles files = installed;
    files.code = "/nowhere/Mono.ttf";
    const Fonts some = loadFonts(atlas, 1.0f, files);
    CHECK(some.problem.find("/nowhere/Mono.ttf") != std::string::npos);
    CHECK(some.problem.find(installed.prose) == std::string::npos);
    CHECK(some.code != nullptr);

    const Fonts none = loadFonts(atlas, 2.0f, {"", "", "", "", "", ""});
    CHECK_FALSE(none.problem.empty());
    CHECK(none.title != nullptr);
    CHECK(atlas.IsBuilt());

    const auto path =
        std::filesystem::temp_directory_path() / ("halfdisk font " + std::to_string(::getpid()) + ".otf");
    std::ofstream(path, std::ios::binary) << "OTTO and then nothing that a font is made of";
    const Fonts broken = loadFonts(atlas, 1.0f, {path, path, path, path, path, path});
    std::filesystem::remove(path);
    CHECK_FALSE(broken.problem.empty());
    CHECK(broken.prose != nullptr);
    CHECK(atlas.IsBuilt());
}

TEST_CASE("another scale takes effect at the next frame") {
    Rig rig;
    rig.driver.frames(2);
    const float before = rig.driver.get("Demo/Next").rect.height();
    rig.host->setUiScale(2.0f);
    CHECK(rig.host->uiScale() == 1.0f);
    rig.driver.frames(2);
    CHECK(rig.host->uiScale() == 2.0f);
    CHECK(rig.driver.get("Demo/Next").rect.height() == doctest::Approx(2 * before).epsilon(0.1));
}

TEST_CASE("the source on the screen is the source that was compiled") {
    CHECK(embeddedSources().size() == 12);
    for (const EmbeddedSource& source : embeddedSources()) {
        CAPTURE(source.file);
        CHECK_FALSE(source.text.empty());
        CHECK(source.text == fileText((std::string(HALFDISK_ROOT "/") + std::string(source.file)).c_str()));
    }
    CHECK(sourceOf("core/cast_ray.h").find("gatherLight") != std::string_view::npos);
    CHECK(sourceOf("core/none.h").empty());
}

TEST_CASE("buttons, boxes and switches are operated by name") {
    Rig rig;
    rig.driver.click("Demo/Next");
    rig.driver.click("Demo/Next");
    CHECK(rig.panel.clicks == 2);
    rig.driver.click("Demo/grid");
    CHECK(rig.panel.ticked);
    rig.driver.click("Demo/as printed");
    CHECK(rig.panel.on);
    rig.driver.click("Demo/as printed");
    CHECK_FALSE(rig.panel.on);
    CHECK_THROWS_WITH_AS(rig.driver.click("Demo/Previous"), doctest::Contains("disabled"),
                         std::runtime_error);
    CHECK_THROWS_WITH_AS(rig.driver.click("Demo/Nxt"), doctest::Contains("Demo/Next"), std::runtime_error);
    rig.driver.moveTo("Demo/canvas");
    rig.driver.frames();
    CHECK(rig.panel.canvasHovered);
}

TEST_CASE("a combo opens and an option is chosen by name") {
    Rig rig;
    rig.driver.click("Demo/sampler");
    rig.driver.click("Demo/sampler/stratified");
    CHECK(rig.panel.choice == 2);
    CHECK(rig.panel.registry.find("Demo/sampler/stratified") == nullptr);
}

TEST_CASE("numbers are dragged") {
    Rig rig;
    rig.driver.dragBy("Demo/seed", 50, 0);
    CHECK(rig.panel.seed > 1);
    rig.driver.dragBy("Demo/N", -2000, 0);
    CHECK(rig.panel.samples == 1);
    rig.driver.dragBy("Demo/N", 2000, 0);
    CHECK(rig.panel.samples == 1'000'000);
}

TEST_CASE("numbers are typed exactly after Ctrl+click and stay in range") {
    Rig rig;
    rig.driver.typeNumber("Demo/N", "12345");
    CHECK(rig.panel.samples == 12345);
    rig.driver.typeNumber("Demo/N", "9999999");
    CHECK(rig.panel.samples == 1'000'000);
    rig.driver.typeNumber("Demo/seed", "18446744073709551615");
    CHECK(rig.panel.seed == UINT64_MAX);
    rig.driver.typeNumber("Demo/depth", "2.5");
    CHECK(rig.panel.depth == 2.5);
}

TEST_CASE("a double click starts typing, too") {
    Rig rig;
    for (const char* name : {"Demo/N", "Demo/seed"}) {
        rig.driver.doubleClick(name);
        rig.driver.typeText("77");
        rig.driver.pressKey(Key::enter);
    }
    CHECK(rig.panel.samples == 77);
    CHECK(rig.panel.seed == 77);
}

TEST_CASE("a text field takes letters from beyond ASCII") {
    Rig rig;
    rig.driver.replaceText("Demo/name", "R\u00e4ume \u03b8");
    CHECK(rig.panel.name == "R\u00e4ume \u03b8");
    rig.driver.click("Demo/name");
    rig.driver.pressKey(Key::end);
    rig.driver.pressKey(Key::backspace);
    rig.driver.pressKey(Key::enter);
    CHECK(rig.panel.name == "R\u00e4ume ");
}

TEST_CASE("keys and characters arrive one frame after they were queued") {
    const auto host = HeadlessHost::withoutGl(300, 200);
    bool space = false, question = false, f12 = false;
    const auto draw = [&] {
        space = keyPressed(Key::space, false);
        f12 = keyPressed(Key::f12, false);
        question = characterTyped('?');
    };
    host->queue(KeyChange{Key::space, true});
    host->queue(KeyChange{Key::f12, true});
    host->queue(Character{U'?'});
    host->frameWithoutDrawing(draw);
    CHECK((space && !f12 && !question));
    host->frameWithoutDrawing(draw);
    CHECK((!space && f12 && !question));
    host->frameWithoutDrawing(draw);
    CHECK((!space && !f12 && question));
    CHECK_FALSE(host->hasQueuedInput());
    host->frameWithoutDrawing(draw);
    CHECK_FALSE(question);
}

TEST_CASE("an exception in the frame function leaves the host usable") {
    Rig rig;
    CHECK_THROWS_AS(rig.host->frame([] { throw std::runtime_error("oops"); }), std::runtime_error);
    rig.driver.click("Demo/Next");
    CHECK(rig.panel.clicks == 1);
    CHECK_THROWS_AS(rig.host->readPixels(), std::logic_error);
}

TEST_CASE("the texts of the demo do not overlap") {
    Rig rig;
    rig.driver.frames(3);
    const auto& widgets = rig.panel.registry.widgets;
    CHECK(std::count_if(widgets.begin(), widgets.end(),
                        [](const Widget& w) { return w.kind == WidgetKind::text; }) == 11);
    for (std::size_t i = 0; i < widgets.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            CAPTURE(widgets[i].name);
            CAPTURE(widgets[k].name);
            CHECK_FALSE(overlap(widgets[i].rect, widgets[k].rect));
        }
}
