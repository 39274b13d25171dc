// Which little screen do the tests of the plumbing operate and photograph?
#include "demo_panel.h"

#include <array>

#include "app/imgui_compat.h"
#include "app/theme.h"

namespace halfdisk {

namespace {

constexpr const char* kCharacters =
    "\u222b \u222e \u03a3 \u2211 \u2207 \u2202 \u221a \u2248 \u2208 \u2264 \u2265 \u2260 \u00b1 \u00b7 "
    "\u00d7 \u00b0 "
    "\u2212 \u2013 \u2014 \u201c\u201d \u2018\u2019 \u2026 \u2192 \u2190 \u2191 \u2193 \u27e8\u27e9 \u221e "
    "\u00bd "
    "\u03c0 \u03b1\u03b2\u03b8\u03c1\u03c6\u03c9\u03a9 x\u00b2 x\u207f N\u2080 L\u1d62 \u2113 \u2713";

}  // namespace

void DemoPanel::draw(const Fonts& fonts) {
    registry.beginFrame();
    const Palette palette;
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("Demo", nullptr, ImGuiWindowFlags_NoDecoration);
    pushFont(fonts.title);
    text(registry, "Light arriving at P: \u222b L cos\u03b8 d\u03b8");
    ImGui::PopFont();
    for (ImFont* font : {fonts.prose, fonts.strong, fonts.emphasis, fonts.code, fonts.formula}) {
        pushFont(font);
        textWrapped(registry,
                    "E = \u222b L(\u03b8) cos\u03b8 d\u03b8 \u2248 (1/N) \u03a3 L\u1d62 cos\u03b8\u1d62 / "
                    "p(\u03b8\u1d62)");
        textWrapped(registry, kCharacters);
        ImGui::PopFont();
    }
    ImGui::PushItemWidth(ImGui::GetFontSize() * 12);
    if (button(registry, "Next")) ++clicks;
    tooltip("Goes on.");
    ImGui::SameLine();
    ImGui::BeginDisabled();
    button(registry, "Previous");
    ImGui::EndDisabled();
    ImGui::SameLine();
    checkbox(registry, "grid", ticked);
    ImGui::SameLine();
    toggle(registry, "as printed", on);
    constexpr std::array<std::string_view, 3> kNames{"uniform", "cosine", "stratified"};
    combo(registry, "sampler", choice, kNames);
    sliderInt(registry, "N", samples, 1, 1'000'000, true);
    dragNumber(registry, "seed##of the poll", seed, {0, UINT64_MAX});
    dragNumber(registry, "depth", depth, {0.0, 8.0, 0.1f, "%.2f"});
    inputText(registry, "##name", name);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 far(corner.x + 300, corner.y + 60);
    ImGui::InvisibleButton("canvas", ImVec2(300, 60));
    canvasHovered = ImGui::IsItemHovered();
    mark(registry, "canvas", corner, far);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    addRect(list, corner, far, palette.ink, 0, 1);
    const std::array<ImVec2, 3> line{ImVec2(corner.x + 10, corner.y + 50),
                                     ImVec2(corner.x + 150, corner.y + 10),
                                     ImVec2(corner.x + 290, corner.y + 50)};
    addPolyline(list, line, palette.rayBright, false, 2);
    ImGui::PopItemWidth();
    ImGui::End();
}

}  // namespace halfdisk
