// What differs between Dear ImGui 1.86 (Debian 12) and later versions? Only here, in keys.h and in
// input_events.h.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>

#include "app/keys.h"

namespace halfdisk {

/// Pressed in this frame; with `repeat` also while it is held.
inline bool keyPressed(Key key, bool repeat = true) {
    return ImGui::IsKeyPressed(keyIndex(key), repeat);
}
inline bool keyDown(Key key) {
    return ImGui::IsKeyDown(keyIndex(key));
}

inline bool anyArrowDown() {
    return keyDown(Key::left) || keyDown(Key::right) || keyDown(Key::up) || keyDown(Key::down);
}

/// Whether the character arrived in this frame, on whatever keyboard. Text fields swallow it.
inline bool characterTyped(ImWchar character) {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantTextInput && io.InputQueueCharacters.contains(character);
}

inline ImTextureID textureId(unsigned name) {
    // A C cast, since ImTextureID is a pointer in one version and an integer in another.
    return (ImTextureID) static_cast<std::intptr_t>(name);
}
inline unsigned textureName(ImTextureID id) {
    return static_cast<unsigned>((std::intptr_t)id);
}

/// A curve through `points` (pixels): prefer it to many single lines.
inline void addPolyline(ImDrawList& list, std::span<const ImVec2> points, ImU32 color, bool closed,
                        float thickness) {
    list.AddPolyline(points.data(), static_cast<int>(points.size()), color,
                     closed ? ImDrawFlags_Closed : ImDrawFlags_None, thickness);
}

inline void addRect(ImDrawList& list, ImVec2 min, ImVec2 max, ImU32 color, float rounding, float thickness) {
    list.AddRect(min, max, color, rounding, ImDrawFlags_None, thickness);
}

/// End with ImGui::EndChild() whatever it returns.
inline bool beginChild(const char* id, ImVec2 size, bool border, ImGuiWindowFlags flags = 0) {
#if IMGUI_VERSION_NUM >= 19000
    return ImGui::BeginChild(id, size, border ? ImGuiChildFlags_Border : 0, flags);
#else
    return ImGui::BeginChild(id, size, border, flags);
#endif
}

inline void pushFont(ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
    ImGui::PushFont(font, font->LegacySize);
#else
    ImGui::PushFont(font);
#endif
}

}  // namespace halfdisk
