// How does a test look at, and close, the window of another program? As any other client of the X display.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "app/png_image.h"

namespace halfdisk {

class XClient {
 public:
    using Window = unsigned long;

    /// Throws std::runtime_error without a display.
    XClient();
    ~XClient();
    XClient(const XClient&) = delete;
    XClient& operator=(const XClient&) = delete;

    /// The window on screen whose title contains `title`.
    std::optional<Window> find(std::string_view title) const;

    /// What it shows, opaque; nothing if it is not wholly on the screen.
    std::optional<Image> picture(Window window) const;

    /// What a window manager sends when its close button is pressed (WM_DELETE_WINDOW).
    void askToClose(Window window);

    /// Into the lower right corner of the screen, where no window under test is.
    void movePointerAway();

 private:
    struct Connection;
    std::unique_ptr<Connection> x_;
};

}  // namespace halfdisk
