// Does the headless host draw the right pixels, and the same ones every time?
#include <doctest/doctest.h>
#include <imgui.h>

#include <cstdlib>
#include <memory>
#include <optional>

#include "app/headless_host.h"
#include "app/theme.h"
#include "demo_panel.h"

using namespace halfdisk;

namespace {

Image photograph(int width, int height, float scale) {
    HeadlessHost host(width, height, scale);
    DemoPanel panel;
    for (int i = 0; i < 3; ++i) host.frame([&] { panel.draw(host.fonts()); });
    return host.readPixels();
}

ImU32 pixel(const Image& image, int x, int y) {
    const std::uint8_t* p = image.at(x, y);
    return IM_COL32(p[0], p[1], p[2], p[3]);
}

}  // namespace

TEST_CASE("frames repeat bit for bit") {
    const Image first = photograph(900, 700, 1.0f);
    if (const char* path = std::getenv("HALFDISK_KEEP_PICTURE")) writePng(path, first);
    CHECK(first == photograph(900, 700, 1.0f));
    CHECK_FALSE(first == photograph(900, 700, 1.25f));
}

TEST_CASE("colours and corners land where they were asked for") {
    HeadlessHost host(64, 48);
    host.frame([] {
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddRectFilled(ImVec2(0, 0), ImVec2(10, 5), IM_COL32(255, 0, 0, 255));
        list.AddRectFilled(ImVec2(60, 40), ImVec2(64, 48), IM_COL32(0, 0, 255, 255));
        list.AddRectFilled(ImVec2(20, 20), ImVec2(30, 30), IM_COL32(0, 0, 0, 128));
    });
    const Image image = host.readPixels();
    CHECK(pixel(image, 0, 0) == IM_COL32(255, 0, 0, 255));
    CHECK(pixel(image, 9, 4) == IM_COL32(255, 0, 0, 255));
    CHECK(pixel(image, 10, 4) == Palette{}.background);
    CHECK(pixel(image, 9, 5) == Palette{}.background);
    CHECK(pixel(image, 63, 47) == IM_COL32(0, 0, 255, 255));
    CHECK(std::abs(image.at(25, 25)[0] - image.at(40, 25)[0] / 2) <= 2);  // half of the paper shines through
}

TEST_CASE("a picture is drawn premultiplied, smoothly, in its place, and forgotten when it is not shown") {
    HeadlessHost host(64, 48);
    // Red that lets half of the paper through, and nothing.
    const auto picture = std::make_shared<const Image>(Image{2, 1, {100, 0, 0, 128, 0, 0, 0, 0}});
    const std::weak_ptr<const Image> watched = picture;
    unsigned drawn = 0;
    const auto show = [&](const std::shared_ptr<const Image>& shown) {
        host.frame([&] {
            ImDrawList& list = *ImGui::GetBackgroundDrawList();
            const ImTextureID id = currentTextures()->idOf(shown);
            drawn = textureName(id);
            list.AddImage(id, ImVec2(10, 10), ImVec2(50, 30));
            list.AddRectFilled(ImVec2(0, 0), ImVec2(5, 5), IM_COL32(0, 0, 255, 255));
        });
    };
    show(picture);
    const Image first = host.readPixels();
    const ImU32 paper = Palette{}.background;
    const auto channel = [](ImU32 color, int shift) { return static_cast<int>((color >> shift) & 255u); };
    CHECK(std::abs(first.at(12, 20)[0] - (100 + channel(paper, 0) * 127 / 255)) <= 2);
    CHECK(std::abs(first.at(12, 20)[1] - channel(paper, 8) * 127 / 255) <= 2);
    CHECK(pixel(first, 48, 20) == paper);  // nothing of the other end comes round
    CHECK(pixel(first, 9, 20) == paper);
    CHECK(pixel(first, 2, 2) == IM_COL32(0, 0, 255, 255));
    const int middle = first.at(30, 20)[1];
    CHECK(middle > first.at(12, 20)[1]);
    CHECK(middle < channel(paper, 8));
    const unsigned name = drawn;
    show(picture);
    CHECK(drawn == name);
    CHECK(host.readPixels() == first);
    show(std::make_shared<const Image>(Image{1, 1, {0, 90, 0, 255}}));
    CHECK(drawn != name);
    CHECK(pixel(host.readPixels(), 48, 20) == IM_COL32(0, 90, 0, 255));
    CHECK(watched.use_count() == 2);  // until the next frame begins
    host.frame([] {});
    CHECK(watched.use_count() == 1);
}

TEST_CASE("more than 65536 vertices in one list are drawn right") {
    HeadlessHost host(400, 300);
    constexpr int kSquares = 30'000;  // 4 vertices each
    host.frame([] {
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        for (int i = 0; i < kSquares; ++i) {
            const auto x = static_cast<float>(i % 200), y = static_cast<float>(i / 200);
            list.AddRectFilled(ImVec2(2 * x, 2 * y), ImVec2(2 * x + 1, 2 * y + 1),
                               IM_COL32(i % 251, (i / 251) % 251, 40, 255));
        }
        CHECK(list.VtxBuffer.Size > 65536);
    });
    const Image image = host.readPixels();
    int wrong = 0;
    for (int i = 0; i < kSquares; ++i)
        wrong += pixel(image, 2 * (i % 200), 2 * (i / 200)) != IM_COL32(i % 251, (i / 251) % 251, 40, 255);
    CHECK(wrong == 0);
}

TEST_CASE("clip rectangles cut and user callbacks are skipped") {
    HeadlessHost host(40, 40);
    host.frame([] {
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddCallback([](const ImDrawList*, const ImDrawCmd*) { FAIL("called"); }, nullptr);
        list.PushClipRect(ImVec2(10, 12), ImVec2(20, 22));
        list.AddRectFilled(ImVec2(0, 0), ImVec2(40, 40), IM_COL32(0, 0, 0, 255));
        list.PopClipRect();
    });
    const Image image = host.readPixels();
    int black = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) black += pixel(image, x, y) == IM_COL32_BLACK;
    CHECK(black == 100);
    CHECK(pixel(image, 10, 12) == IM_COL32_BLACK);
    CHECK(pixel(image, 19, 21) == IM_COL32_BLACK);
}

TEST_CASE("resizing and rescaling keep drawing, and end where a fresh host begins") {
    HeadlessHost host(500, 400, 2.0f);
    DemoPanel panel;
    const auto draw = [&] { panel.draw(host.fonts()); };
    host.frame(draw);
    host.resize(900, 700);
    host.setUiScale(1.0f);
    for (int i = 0; i < 3; ++i) host.frame(draw);
    CHECK(host.readPixels() == photograph(900, 700, 1.0f));
    CHECK_THROWS_AS(host.resize(0, 10), std::invalid_argument);
}

TEST_CASE("two hosts at a time do not disturb each other") {
    HeadlessHost a(300, 200), b(200, 100);
    const auto fill = [](ImU32 color) {
        return
            [color] { ImGui::GetBackgroundDrawList()->AddRectFilled(ImVec2(0, 0), ImVec2(300, 200), color); };
    };
    a.frame(fill(IM_COL32(255, 0, 0, 255)));
    b.frame(fill(IM_COL32(0, 255, 0, 255)));
    CHECK(pixel(a.readPixels(), 299, 199) == IM_COL32(255, 0, 0, 255));
    CHECK(pixel(b.readPixels(), 199, 99) == IM_COL32(0, 255, 0, 255));
}
