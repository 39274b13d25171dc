// How does the program open a window, and what happens between its frames?
#include "app/window_host.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>

#include "app/theme.h"

namespace halfdisk {

namespace {

constexpr int kLeastWidth = 960, kLeastHeight = 600;
constexpr double kFrameSeconds = 1.0 / 60.0;

// The one variable outside any object: a signal handler can reach nothing else.
std::atomic<bool> stopSignalled{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

extern "C" void onStopSignal(int) {
    stopSignalled = true;
}

/// While it lives, SIGINT and SIGTERM ask the window to close instead of ending the process.
class StopSignals {
 public:
    StopSignals() {
        stopSignalled = false;
        struct sigaction action {};
        action.sa_handler = onStopSignal;
        sigaction(SIGINT, &action, &interruptBefore);
        sigaction(SIGTERM, &action, &terminateBefore);
    }
    ~StopSignals() {
        sigaction(SIGINT, &interruptBefore, nullptr);
        sigaction(SIGTERM, &terminateBefore, nullptr);
    }
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

 private:
    struct sigaction interruptBefore {
    }, terminateBefore{};
};

std::string glfwProblem(const char* what) {
    const char* description = nullptr;
    glfwGetError(&description);
    return fmt::format("{}: {}", what, description ? description : "unknown reason");
}

/// Content scale of the display, apart from what the framebuffer scale already covers.
float densityScale(GLFWwindow* window) {
    float contentX = 1.0f, contentY = 1.0f;
    glfwGetWindowContentScale(window, &contentX, &contentY);
    int width = 0, framebufferWidth = 0, height = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &framebufferWidth, &height);
    const float covered = width > 0 && framebufferWidth > 0
                              ? static_cast<float>(framebufferWidth) / static_cast<float>(width)
                              : 1.0f;
    return std::max(1.0f, contentX / covered);
}

void setHints() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SAMPLES, 0);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
}

}  // namespace

bool hasDisplay() {
    if (!glfwInit()) return false;
    glfwTerminate();
    return true;
}

std::unique_ptr<WindowHost> WindowHost::open(const WindowOptions& options, std::string& whyNot) {
    if (!glfwInit()) {
        whyNot = glfwProblem("no display");
        return nullptr;
    }
    setHints();
    GLFWwindow* window =
        glfwCreateWindow(std::max(kLeastWidth, options.width), std::max(kLeastHeight, options.height),
                         options.title.c_str(), nullptr, nullptr);
    if (!window) {
        whyNot = glfwProblem("cannot open a window");
        glfwTerminate();
        return nullptr;
    }
    try {
        return std::unique_ptr<WindowHost>(new WindowHost(window, options));
    } catch (const std::exception& error) {
        whyNot = fmt::format("cannot draw in a window: {}", error.what());
        glfwDestroyWindow(window);
        glfwTerminate();
        return nullptr;
    }
}

WindowHost::WindowHost(GLFWwindow* openWindow, const WindowOptions& options)
    : window(openWindow), userScale(options.uiScale), onDrop(options.onDrop) {
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(window, kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
    gl = loadGlFunctions(glfwGetProcAddress);
    ui = std::make_unique<UiContext>(userScale * densityScale(window));
    renderer = std::make_unique<DrawListRenderer>(gl);
    glfwSetWindowUserPointer(window, this);
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* changed, float, float) {
        static_cast<WindowHost*>(glfwGetWindowUserPointer(changed))->requestScale();
    });
    glfwSetDropCallback(window, [](GLFWwindow* target, int count, const char** paths) {
        const auto* host = static_cast<WindowHost*>(glfwGetWindowUserPointer(target));
        if (host->onDrop) host->onDrop({paths, paths + count});
    });
    ImGui_ImplGlfw_InitForOpenGL(window, true);
}

WindowHost::~WindowHost() {
    ui->makeCurrent();
    glfwMakeContextCurrent(window);
    renderer.reset();
    ImGui_ImplGlfw_Shutdown();
    ui.reset();
    glfwDestroyWindow(window);
    glfwTerminate();
}

void WindowHost::run(const std::function<void()>& draw, const std::function<void()>& between) {
    const StopSignals signals;
    using Clock = std::chrono::steady_clock;
    while (!closing() && !stopSignalled) {
        const Clock::time_point start = Clock::now();
        if (glfwGetWindowAttrib(window, GLFW_ICONIFIED)) {
            glfwWaitEventsTimeout(0.25);
            continue;
        }
        frame(draw);
        present();
        between();
        // Where nothing paces the buffer swap (a virtual display, a driver without vsync), do not burn a
        // core.
        const auto left = [&] {
            return kFrameSeconds - std::chrono::duration<double>(Clock::now() - start).count();
        };
        for (double seconds = left(); seconds > 0.001; seconds = left()) glfwWaitEventsTimeout(seconds);
    }
}

void WindowHost::frame(const std::function<void()>& draw) {
    ui->makeCurrent();
    glfwMakeContextCurrent(window);
    glfwPollEvents();
    if (ui->applyRequestedScale()) renderer->uploadFonts();
    ui->beginFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    try {
        draw();
    } catch (...) {
        ImGui::EndFrame();
        throw;
    }
    ImGui::Render();
    renderer->render(*ImGui::GetDrawData(), Palette{}.background, ui->textures());
}

Image WindowHost::readPixels() {
    glfwMakeContextCurrent(window);
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    return readFramebuffer(gl, width, height);
}

void WindowHost::present() {
    glfwSwapBuffers(window);
}

void WindowHost::close() {
    glfwSetWindowShouldClose(window, GLFW_TRUE);
}

bool WindowHost::closing() const {
    return glfwWindowShouldClose(window);
}

void WindowHost::setTitle(const std::string& title) {
    glfwSetWindowTitle(window, title.c_str());
}

void WindowHost::setUiScale(float uiScale) {
    userScale = uiScale;
    requestScale();
}

void WindowHost::requestScale() {
    ui->requestScale(userScale * densityScale(window));
}

}  // namespace halfdisk
