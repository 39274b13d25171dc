// How does a test operate the program by the names of its widgets?
#include "driver.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <stdexcept>
#include <string>

namespace halfdisk {

namespace {

std::string namesOnScreen(const WidgetRegistry& registry) {
    std::string names;
    for (const auto& [name, rect] : registry.rects) names += "\n  " + name;
    return names;
}

}  // namespace

void Driver::frames(int count) {
    for (int i = 0; i < count; ++i) host.frameWithoutDrawing(draw);
    framesSinceRelease += count;
}

void Driver::waitOutDoubleClick() {
    constexpr int kFramesApart = 20;  // a third of a second; ImGui takes 0.3 s for a double click
    if (framesSinceRelease < kFramesApart) frames(kFramesApart - framesSinceRelease);
}

void Driver::send(const InputEvent& event) {
    host.queue(event);
    frames();
}

const Widget& Driver::get(std::string_view name) {
    if (registry.widgets.empty()) frames(2);
    const Widget* widget = registry.find(name);
    if (!widget)
        throw std::runtime_error(
            fmt::format("no widget {} on screen, but:{}", name, namesOnScreen(registry)));
    return *widget;
}

void Driver::moveTo(float x, float y) {
    send(MouseMove{x, y});
}

void Driver::moveTo(std::string_view name) {
    const Widget& widget = get(name);
    if (widget.target.width() < 1 || widget.target.height() < 1)
        throw std::runtime_error(fmt::format("widget {} is outside of its window's visible part", name));
    moveTo(widget.target.centerX(), widget.target.centerY());
}

void Driver::press(int mouseButton) {
    send(MouseButton{mouseButton, true});
}

void Driver::release(int mouseButton) {
    send(MouseButton{mouseButton, false});
    framesSinceRelease = 0;
}

void Driver::click(std::string_view name) {
    waitOutDoubleClick();
    moveTo(name);
    if (!get(name).enabled) throw std::runtime_error(fmt::format("widget {} is disabled", name));
    press();
    release();
    frames();
}

void Driver::doubleClick(std::string_view name) {
    waitOutDoubleClick();
    moveTo(name);
    for (int i = 0; i < 2; ++i) {
        press();
        release();
    }
    frames();
}

void Driver::clickAt(float x, float y) {
    waitOutDoubleClick();
    moveTo(x, y);
    press();
    release();
    frames();
}

void Driver::dragTo(std::string_view name, float x, float y) {
    waitOutDoubleClick();
    moveTo(name);
    const Rect from = get(name).target;
    press();
    constexpr int kSteps = 4;
    for (int i = 1; i <= kSteps; ++i) {
        const float t = static_cast<float>(i) / kSteps;
        moveTo(from.centerX() + t * (x - from.centerX()), from.centerY() + t * (y - from.centerY()));
    }
    release();
    frames();
}

void Driver::dragBy(std::string_view name, float dx, float dy) {
    const Rect from = get(name).target;
    dragTo(name, from.centerX() + dx, from.centerY() + dy);
}

void Driver::wheel(std::string_view name, float up) {
    moveTo(name);
    send(MouseWheel{up, 0});
    frames();
}

void Driver::pressKey(Key key) {
    send(KeyChange{key, true});
    send(KeyChange{key, false});
    frames();
}

void Driver::pressKey(Key modifier, Key key) {
    send(KeyChange{modifier, true});
    pressKey(key);
    send(KeyChange{modifier, false});
}

void Driver::typeText(std::string_view utf8) {
    const char* at = utf8.data();
    const char* end = at + utf8.size();
    while (at < end) {
        unsigned character = 0;
        at += ImTextCharFromUtf8(&character, at, end);
        send(Character{static_cast<char32_t>(character)});
    }
    frames();
}

void Driver::typeNumber(std::string_view name, std::string_view digits) {
    send(KeyChange{Key::ctrl, true});
    click(name);
    send(KeyChange{Key::ctrl, false});
    typeText(digits);
    pressKey(Key::enter);
}

void Driver::replaceText(std::string_view name, std::string_view utf8) {
    click(name);
    pressKey(Key::ctrl, Key::a);
    typeText(utf8);
    pressKey(Key::enter);
}

}  // namespace halfdisk
