// How does a test look at, and close, the window of another program? As any other client of the X display.
#include "x_client.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <stdexcept>
#include <vector>

namespace halfdisk {

namespace {

/// A window may vanish between two requests: that is an answer, not the end of the test.
int ignoreError(Display*, XErrorEvent*) {
    return 0;
}

std::optional<Window> findBelow(Display* display, Window window, std::string_view title) {
    char* name = nullptr;
    if (XFetchName(display, window, &name) != 0 && name != nullptr) {
        const bool found = std::string_view(name).find(title) != std::string_view::npos;
        XFree(name);
        XWindowAttributes attributes{};
        if (found && XGetWindowAttributes(display, window, &attributes) != 0 &&
            attributes.map_state == IsViewable)
            return window;
    }
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, window, &root, &parent, &children, &count) == 0 || children == nullptr) return {};
    const std::vector<Window> below(children, children + count);
    XFree(children);
    for (const Window child : below)
        if (const auto found = findBelow(display, child, title)) return found;
    return {};
}

}  // namespace

struct XClient::Connection {
    Display* display;
};

XClient::XClient() : x_(std::make_unique<Connection>()) {
    XSetErrorHandler(ignoreError);
    x_->display = XOpenDisplay(nullptr);
    if (x_->display == nullptr) throw std::runtime_error("no X display");
}

XClient::~XClient() {
    XCloseDisplay(x_->display);
}

std::optional<XClient::Window> XClient::find(std::string_view title) const {
    return findBelow(x_->display, DefaultRootWindow(x_->display), title);
}

std::optional<Image> XClient::picture(Window window) const {
    XWindowAttributes attributes{};
    if (XGetWindowAttributes(x_->display, window, &attributes) == 0 || attributes.map_state != IsViewable)
        return {};
    const auto width = static_cast<unsigned>(attributes.width),
               height = static_cast<unsigned>(attributes.height);
    XImage* pixels = XGetImage(x_->display, window, 0, 0, width, height, AllPlanes, ZPixmap);
    if (pixels == nullptr) return {};
    Image image{attributes.width, attributes.height, {}};
    image.rgba.reserve(std::size_t{4} * width * height);
    for (int y = 0; y < attributes.height; ++y)
        for (int x = 0; x < attributes.width; ++x) {
            const unsigned long pixel = XGetPixel(pixels, x, y);
            for (const int shift : {16, 8, 0})
                image.rgba.push_back(static_cast<std::uint8_t>((pixel >> shift) & 255u));
            image.rgba.push_back(255);
        }
    XDestroyImage(pixels);
    return image;
}

void XClient::askToClose(Window window) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(x_->display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(x_->display, "WM_DELETE_WINDOW", False));
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(x_->display, window, False, NoEventMask, &event);
    XSync(x_->display, False);
}

void XClient::movePointerAway() {
    const int screen = DefaultScreen(x_->display);
    XWarpPointer(x_->display, None, DefaultRootWindow(x_->display), 0, 0, 0, 0,
                 DisplayWidth(x_->display, screen) - 1, DisplayHeight(x_->display, screen) - 1);
    XSync(x_->display, False);
}

}  // namespace halfdisk
