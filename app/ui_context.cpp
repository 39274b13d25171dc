// What do window and headless host share? One Dear ImGui context with its fonts and style, at one scale.
#include "app/ui_context.h"

#include <imgui.h>

#include <algorithm>

#include "app/theme.h"

namespace halfdisk {

namespace {

float sensible(float scale) {
    return std::clamp(scale, 0.5f, 6.0f);
}

}  // namespace

UiContext::UiContext(float uiScale) : context(ImGui::CreateContext()), currentScale(sensible(uiScale)) {
    makeCurrent();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().BackendRendererUserData = &shownTextures;
    rebuild();
}

UiContext::~UiContext() {
    makeCurrent();
    ImGui::GetIO().BackendRendererUserData = nullptr;
    ImGui::DestroyContext(context);
}

void UiContext::makeCurrent() const {
    ImGui::SetCurrentContext(context);
}

void UiContext::requestScale(float uiScale) {
    requestedScale = sensible(uiScale);
}

bool UiContext::applyRequestedScale() {
    if (!requestedScale || *requestedScale == currentScale) return false;
    currentScale = *requestedScale;
    rebuild();
    return true;
}

void UiContext::rebuild() {
    applyTheme(ImGui::GetStyle(), currentScale);
    loadedFonts = loadFonts(*ImGui::GetIO().Fonts, currentScale);
}

}  // namespace halfdisk
