// How does scripted input (tests, no window) reach Dear ImGui? All writes to io's input fields are here.
#pragma once

#include <imgui.h>

#include <cfloat>
#include <variant>

#include "app/imgui_compat.h"

namespace halfdisk {

/// Pixels from the left upper corner.
struct MouseMove {
    float x, y;
};

/// Press or release; 0 left, 1 right, 2 middle.
struct MouseButton {
    int button;
    bool down;
};

/// Notches.
struct MouseWheel {
    float up, right;
};

/// Press or release. The modifiers are keys of their own: Key::ctrl, Key::shift, Key::alt.
struct KeyChange {
    Key key;
    bool down;
};

struct Character {
    char32_t value;
};

using InputEvent = std::variant<MouseMove, MouseButton, MouseWheel, KeyChange, Character>;

/// Before 1.87 ImGui has to be told under which index it finds the keys that it uses itself.
inline void mapKeys(ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
    // The first keys of both enumerations come in the same order.
    static_assert(static_cast<int>(Key::tab) == ImGuiKey_Tab && static_cast<int>(Key::end) == ImGuiKey_End &&
                  static_cast<int>(Key::keypadEnter) == ImGuiKey_KeyPadEnter);
    for (int key = ImGuiKey_Tab; key <= ImGuiKey_KeyPadEnter; ++key)
        io.KeyMap[key] = keyIndex(static_cast<Key>(key));
    io.KeyMap[ImGuiKey_A] = keyIndex(Key::a);
    io.KeyMap[ImGuiKey_C] = keyIndex(Key::c);
    io.KeyMap[ImGuiKey_V] = keyIndex(Key::v);
    io.KeyMap[ImGuiKey_X] = keyIndex(Key::x);
    io.KeyMap[ImGuiKey_Y] = keyIndex(Key::y);
    io.KeyMap[ImGuiKey_Z] = keyIndex(Key::z);
#else
    static_cast<void>(io);
#endif
}

inline void applyInput(ImGuiIO& io, const MouseMove& event) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddMousePosEvent(event.x, event.y);
#else
    io.MousePos = ImVec2(event.x, event.y);
#endif
}

inline void applyInput(ImGuiIO& io, const MouseButton& event) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddMouseButtonEvent(event.button, event.down);
#else
    io.MouseDown[event.button] = event.down;
#endif
}

inline void applyInput(ImGuiIO& io, const MouseWheel& event) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddMouseWheelEvent(event.right, event.up);
#else
    io.MouseWheel += event.up;
    io.MouseWheelH += event.right;
#endif
}

inline void applyInput(ImGuiIO& io, const KeyChange& event) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddKeyEvent(keyIndex(event.key), event.down);
    if (event.key == Key::ctrl) io.AddKeyEvent(ImGuiMod_Ctrl, event.down);
    if (event.key == Key::shift) io.AddKeyEvent(ImGuiMod_Shift, event.down);
    if (event.key == Key::alt) io.AddKeyEvent(ImGuiMod_Alt, event.down);
#else
    io.KeysDown[keyIndex(event.key)] = event.down;
    if (event.key == Key::ctrl) io.KeyCtrl = event.down;
    if (event.key == Key::shift) io.KeyShift = event.down;
    if (event.key == Key::alt) io.KeyAlt = event.down;
#endif
}

inline void applyInput(ImGuiIO& io, const Character& event) {
    io.AddInputCharacter(event.value);
}

inline void applyInput(ImGuiIO& io, const InputEvent& event) {
    std::visit([&io](const auto& one) { applyInput(io, one); }, event);
}

/// While it lives, ImGui believes that Ctrl is held: turns a click on a number into exact typing.
class CtrlHeld {
 public:
    CtrlHeld(ImGuiIO& inputs, bool held) : io(inputs), before(inputs.KeyCtrl) { io.KeyCtrl = before || held; }
    ~CtrlHeld() { io.KeyCtrl = before; }
    CtrlHeld(const CtrlHeld&) = delete;
    CtrlHeld& operator=(const CtrlHeld&) = delete;

 private:
    ImGuiIO& io;
    bool before;
};

/// While it lives, within one frame, the pointer is over nothing.
class PointerAway {
 public:
    explicit PointerAway(ImGuiIO& inputs) : io(inputs), before(inputs.MousePos) {
        io.MousePos = {-FLT_MAX, -FLT_MAX};
    }
    ~PointerAway() { io.MousePos = before; }
    PointerAway(const PointerAway&) = delete;
    PointerAway& operator=(const PointerAway&) = delete;

 private:
    ImGuiIO& io;
    ImVec2 before;
};

}  // namespace halfdisk
