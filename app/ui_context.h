// What do window and headless host share? One Dear ImGui context with its fonts and style, at one scale.
#pragma once

#include <optional>

#include "app/fonts.h"
#include "app/textures.h"

struct ImGuiContext;

namespace halfdisk {

class UiContext {
 public:
    /// No settings file, no wall clock: a fresh context behaves the same every time. Current after
    /// construction.
    explicit UiContext(float uiScale);
    ~UiContext();
    UiContext(const UiContext&) = delete;
    UiContext& operator=(const UiContext&) = delete;

    void makeCurrent() const;

    /// To be called before ImGui's NewFrame.
    void beginFrame() { shownTextures.beginFrame(); }
    const Textures& textures() const { return shownTextures; }

    const Fonts& fonts() const { return loadedFonts; }
    float scale() const { return currentScale; }

    /// Takes effect at the next frame, since fonts cannot change within one. Kept within 0.5 ... 6.
    void requestScale(float uiScale);

    /// Between frames: rebuilds fonts and style if another scale was asked for. True if the atlas must be
    /// uploaded.
    bool applyRequestedScale();

 private:
    void rebuild();

    ImGuiContext* context;
    float currentScale;
    std::optional<float> requestedScale;
    Fonts loadedFonts;
    Textures shownTextures;
};

}  // namespace halfdisk
