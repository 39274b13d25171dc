// How does a test operate the program by the names of its widgets?
#pragma once

#include <functional>
#include <string_view>

#include "app/headless_host.h"
#include "app/widgets.h"

namespace halfdisk {

/// Sends events through a host's queue and runs one frame for each, then one more to settle. `draw` is the
/// frame function; it must clear `registry` first. Nothing is drawn, so it is fast. Throws
/// std::runtime_error, listing the names on screen, if a widget is missing, disabled or clipped away.
struct Driver {
    HeadlessHost& host;
    WidgetRegistry& registry;
    std::function<void()> draw;
    int framesSinceRelease = 1000;  ///< so that two gestures are no double click

    void frames(int count = 1);
    const Widget& get(std::string_view name);  ///< valid until the next frame

    void moveTo(float x, float y);
    void moveTo(std::string_view name);  ///< to the middle of its target
    void press(int mouseButton = 0);
    void release(int mouseButton = 0);

    void click(std::string_view name);
    void doubleClick(std::string_view name);
    void clickAt(float x, float y);

    /// Press in the middle of `name`, move in steps, release.
    void dragTo(std::string_view name, float x, float y);
    void dragBy(std::string_view name, float dx, float dy);
    void wheel(std::string_view name, float up);

    void pressKey(Key key);
    void pressKey(Key modifier, Key key);
    void typeText(std::string_view utf8);
    /// Ctrl+click, the text, Enter: exact typing into a number.
    void typeNumber(std::string_view name, std::string_view digits);
    /// Click, Ctrl+A, the text, Enter: for text fields.
    void replaceText(std::string_view name, std::string_view utf8);

 private:
    void send(const InputEvent& event);
    void waitOutDoubleClick();
};

}  // namespace halfdisk
