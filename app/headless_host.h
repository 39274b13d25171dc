// How does the program draw, and take input, without a display?
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "app/draw_list_renderer.h"
#include "app/fonts.h"
#include "app/input_events.h"
#include "app/png_image.h"
#include "app/ui_context.h"

namespace halfdisk {

/// Software OpenGL (OSMesa) into memory. The same frames give the same bits. Time advances by 1/60 s per
/// frame, never by the clock. At most one event of the input queue is applied per frame.
class HeadlessHost {
 public:
    /// Throws std::runtime_error, naming the Debian package, if the library or OpenGL 3.3 is missing.
    HeadlessHost(int width, int height, float uiScale = 1.0f);

    /// No OpenGL at all: `frame` lays out and reacts but draws nothing, `readPixels` throws. For tests of
    /// interaction.
    static std::unique_ptr<HeadlessHost> withoutGl(int width, int height, float uiScale = 1.0f);

    ~HeadlessHost();
    HeadlessHost(const HeadlessHost&) = delete;
    HeadlessHost& operator=(const HeadlessHost&) = delete;

    /// One frame: input, `draw` (which calls ImGui), pixels.
    void frame(const std::function<void()>& draw);

    /// The same without the pixels: all of our own and ImGui's work, none of the software GL's.
    void frameWithoutDrawing(const std::function<void()>& draw);

    /// What the last `frame` drew.
    Image readPixels();

    void resize(int width, int height);  ///< from the next frame on
    int width() const { return pixelWidth; }
    int height() const { return pixelHeight; }

    void setUiScale(float uiScale) { ui.requestScale(uiScale); }  ///< from the next frame on
    float uiScale() const { return ui.scale(); }
    const Fonts& fonts() const { return ui.fonts(); }

    void queue(const InputEvent& event) { events.push_back(event); }
    bool hasQueuedInput() const { return !events.empty(); }

 private:
    struct Surface;
    enum class Gl { none, software };
    HeadlessHost(int width, int height, float uiScale, Gl gl);
    void layOut(const std::function<void()>& draw);

    int pixelWidth, pixelHeight;
    UiContext ui;
    std::deque<InputEvent> events;
    std::unique_ptr<Surface> surface;            ///< null without GL
    std::unique_ptr<DrawListRenderer> renderer;  ///< null without GL
};

}  // namespace halfdisk
