// Which keys does the program listen to, and how does Dear ImGui number them?
#pragma once

#include <imgui.h>

#include <cstdint>

#if IMGUI_VERSION_NUM < 18700
#include <GLFW/glfw3.h>
#endif

namespace halfdisk {

/// The keys that the program listens to, by their place on a US keyboard. Characters such as `?` do not
/// belong here: where they lie depends on the layout, so ask `characterTyped`.
enum class Key : std::uint8_t {
    tab,
    left,
    right,
    up,
    down,
    pageUp,
    pageDown,
    home,
    end,
    insert,
    del,
    backspace,
    space,
    enter,
    escape,
    keypadEnter,
    minus,
    equal,
    leftBracket,
    rightBracket,
    comma,
    period,
    slash,
    digit0,
    digit1,
    digit2,
    digit3,
    digit4,
    digit5,
    digit6,
    digit7,
    digit8,
    digit9,
    a,
    b,
    c,
    d,
    e,
    f,
    g,
    h,
    i,
    j,
    k,
    l,
    m,
    n,
    o,
    p,
    q,
    r,
    s,
    t,
    u,
    v,
    w,
    x,
    y,
    z,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12,
    ctrl,
    shift,
    alt,
    count
};

#if IMGUI_VERSION_NUM >= 18700
using ImGuiKeyIndex = ImGuiKey;
#else
using ImGuiKeyIndex = int;
#endif

/// What ImGui's key functions want: before 1.87 an index into io.KeysDown, for which both hosts use GLFW's
/// numbers.
constexpr ImGuiKeyIndex keyIndex(Key key) {
#if IMGUI_VERSION_NUM >= 18700
    constexpr ImGuiKey kKeys[] = {
        ImGuiKey_Tab,       ImGuiKey_LeftArrow, ImGuiKey_RightArrow,  ImGuiKey_UpArrow,
        ImGuiKey_DownArrow, ImGuiKey_PageUp,    ImGuiKey_PageDown,    ImGuiKey_Home,
        ImGuiKey_End,       ImGuiKey_Insert,    ImGuiKey_Delete,      ImGuiKey_Backspace,
        ImGuiKey_Space,     ImGuiKey_Enter,     ImGuiKey_Escape,      ImGuiKey_KeypadEnter,
        ImGuiKey_Minus,     ImGuiKey_Equal,     ImGuiKey_LeftBracket, ImGuiKey_RightBracket,
        ImGuiKey_Comma,     ImGuiKey_Period,    ImGuiKey_Slash};
    constexpr ImGuiKey kDigit0 = ImGuiKey_0, kA = ImGuiKey_A, kF1 = ImGuiKey_F1;
    constexpr ImGuiKey kModifiers[] = {ImGuiKey_LeftCtrl, ImGuiKey_LeftShift, ImGuiKey_LeftAlt};
#else
    constexpr int kKeys[] = {GLFW_KEY_TAB,   GLFW_KEY_LEFT,    GLFW_KEY_RIGHT,        GLFW_KEY_UP,
                             GLFW_KEY_DOWN,  GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN,    GLFW_KEY_HOME,
                             GLFW_KEY_END,   GLFW_KEY_INSERT,  GLFW_KEY_DELETE,       GLFW_KEY_BACKSPACE,
                             GLFW_KEY_SPACE, GLFW_KEY_ENTER,   GLFW_KEY_ESCAPE,       GLFW_KEY_KP_ENTER,
                             GLFW_KEY_MINUS, GLFW_KEY_EQUAL,   GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET,
                             GLFW_KEY_COMMA, GLFW_KEY_PERIOD,  GLFW_KEY_SLASH};
    constexpr int kDigit0 = GLFW_KEY_0, kA = GLFW_KEY_A, kF1 = GLFW_KEY_F1;
    constexpr int kModifiers[] = {GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_LEFT_ALT};
#endif
    if (key < Key::digit0) return kKeys[static_cast<int>(key)];
    const auto after = [key](Key first) { return static_cast<int>(key) - static_cast<int>(first); };
    if (key < Key::a) return static_cast<ImGuiKeyIndex>(kDigit0 + after(Key::digit0));
    if (key < Key::f1) return static_cast<ImGuiKeyIndex>(kA + after(Key::a));
    if (key < Key::ctrl) return static_cast<ImGuiKeyIndex>(kF1 + after(Key::f1));
    return kModifiers[after(Key::ctrl)];
}

}  // namespace halfdisk
