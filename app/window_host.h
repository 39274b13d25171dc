// How does the program open a window, and what happens between its frames?
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/draw_list_renderer.h"
#include "app/fonts.h"
#include "app/png_image.h"
#include "app/ui_context.h"

struct GLFWwindow;

namespace halfdisk {

/// Whether there is a display. Cheap; opens nothing. Not while a WindowHost exists.
bool hasDisplay();

struct WindowOptions {
    std::string title = "Halfdisk";
    int width = 1280, height = 800;  ///< screen units; at least 960 x 600
    float uiScale = 1.0f;            ///< multiplies what the display's pixel density asks for
    std::function<void(const std::vector<std::filesystem::path>&)> onDrop;  ///< files dropped on the window
};

/// A GLFW window. The same draw function gives the same pixels as in HeadlessHost at the same framebuffer
/// size: no multisampling, no sRGB framebuffer, the same fonts and the same renderer. At most one at a time.
class WindowHost {
 public:
    /// Null, and why in `whyNot`, if there is no display or no OpenGL 3.3.
    static std::unique_ptr<WindowHost> open(const WindowOptions& options, std::string& whyNot);

    ~WindowHost();
    WindowHost(const WindowHost&) = delete;
    WindowHost& operator=(const WindowHost&) = delete;

    /// Frames until the window is closed, `close` is called, or SIGINT or SIGTERM arrives. Follows the
    /// display's rate, at most 60 frames a second; sleeps while the window is iconified. `between`, after
    /// each frame that is shown, may draw frames of its own, which are not.
    void run(
        const std::function<void()>& draw, const std::function<void()>& between = [] {});

    /// One frame: input, `draw`, pixels in the back buffer. For tests, `readPixels` may follow, then
    /// `present`.
    void frame(const std::function<void()>& draw);
    Image readPixels();
    void present();

    void close();  ///< ends `run` after the current frame
    bool closing() const;

    void setTitle(const std::string& title);
    void setUiScale(float uiScale);  ///< from the next frame on
    float uiScale() const { return userScale; }
    float fullScale() const { return ui->scale(); }  ///< times the display's density: pixels per design pixel
    const Fonts& fonts() const { return ui->fonts(); }

 private:
    WindowHost(GLFWwindow* openWindow, const WindowOptions& options);
    void requestScale();

    GLFWwindow* window;
    float userScale;
    std::function<void(const std::vector<std::filesystem::path>&)> onDrop;
    GlFunctions gl;
    std::unique_ptr<UiContext> ui;
    std::unique_ptr<DrawListRenderer> renderer;
};

}  // namespace halfdisk
