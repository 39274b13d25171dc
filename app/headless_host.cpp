// How does the program draw, and take input, without a display?
#include "app/headless_host.h"

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <stdexcept>

#include "app/theme.h"

namespace halfdisk {

namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";
constexpr int kLargestSide = 16384;

/// Loaded by name so that a machine without the library can still open a window. Never unloaded: its threads
/// and exit handlers stay.
struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) createContextAttribs;
    decltype(&OSMesaDestroyContext) destroyContext;
    decltype(&OSMesaMakeCurrent) makeCurrent;
    GlGetProc getProcAddress;
};

template <class Function>
void loadSymbol(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (!function) throw std::runtime_error(fmt::format("{} has no {}", kLibrary, name));
}

OsMesa loadOsMesa() {
    void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        throw std::runtime_error(
            fmt::format("cannot draw without a display: {} (Debian package libosmesa6)", dlerror()));
    OsMesa mesa{};
    loadSymbol(library, "OSMesaCreateContextAttribs", mesa.createContextAttribs);
    loadSymbol(library, "OSMesaDestroyContext", mesa.destroyContext);
    loadSymbol(library, "OSMesaMakeCurrent", mesa.makeCurrent);
    loadSymbol(library, "OSMesaGetProcAddress", mesa.getProcAddress);
    return mesa;
}

int sensibleSide(int pixels) {
    if (pixels < 1 || pixels > kLargestSide)
        throw std::invalid_argument(fmt::format("a picture cannot be {} pixels wide or high", pixels));
    return pixels;
}

}  // namespace

/// A GL context and the memory that it draws into.
struct HeadlessHost::Surface {
    OsMesa mesa = loadOsMesa();
    OSMesaContext context = nullptr;
    std::vector<std::uint8_t> memory;
    GlFunctions gl;

    Surface(int width, int height) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_STENCIL_BITS,
                                  0,
                                  OSMESA_ACCUM_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        context = mesa.createContextAttribs(attributes, nullptr);
        if (!context) throw std::runtime_error(fmt::format("{} offers no OpenGL 3.3", kLibrary));
        try {
            makeCurrent(width, height);
            gl = loadGlFunctions(mesa.getProcAddress);
        } catch (...) {
            mesa.destroyContext(context);
            throw;
        }
    }

    ~Surface() {
        mesa.makeCurrent(nullptr, nullptr, 0, 0, 0);
        mesa.destroyContext(context);
    }

    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    void makeCurrent(int width, int height) {
        memory.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        if (!mesa.makeCurrent(context, memory.data(), GL_UNSIGNED_BYTE, width, height))
            throw std::runtime_error(fmt::format("{} cannot draw {}x{} pixels", kLibrary, width, height));
    }
};

HeadlessHost::HeadlessHost(int width, int height, float uiScale)
    : HeadlessHost(width, height, uiScale, Gl::software) {}

std::unique_ptr<HeadlessHost> HeadlessHost::withoutGl(int width, int height, float uiScale) {
    return std::unique_ptr<HeadlessHost>(new HeadlessHost(width, height, uiScale, Gl::none));
}

HeadlessHost::HeadlessHost(int width, int height, float uiScale, Gl gl)
    : pixelWidth(sensibleSide(width)), pixelHeight(sensibleSide(height)), ui(uiScale) {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendPlatformName = "headless";
    io.DeltaTime = 1.0f / 60.0f;
    mapKeys(io);
    applyInput(io, MouseMove{-FLT_MAX, -FLT_MAX});
    if (gl == Gl::software) {
        surface = std::make_unique<Surface>(width, height);
        renderer = std::make_unique<DrawListRenderer>(surface->gl);
    } else {
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // so that both kinds lay out alike
    }
}

HeadlessHost::~HeadlessHost() {
    ui.makeCurrent();
    if (surface) surface->makeCurrent(pixelWidth, pixelHeight);
    renderer.reset();
}

void HeadlessHost::layOut(const std::function<void()>& draw) {
    ui.makeCurrent();
    if (surface) surface->makeCurrent(pixelWidth, pixelHeight);
    if (ui.applyRequestedScale() && renderer) renderer->uploadFonts();
    ui.beginFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(pixelWidth), static_cast<float>(pixelHeight));
    io.DeltaTime = 1.0f / 60.0f;
    if (!events.empty()) {
        applyInput(io, events.front());
        events.pop_front();
    }
    ImGui::NewFrame();
    try {
        draw();
    } catch (...) {
        ImGui::EndFrame();
        throw;
    }
    ImGui::Render();
}

void HeadlessHost::frame(const std::function<void()>& draw) {
    layOut(draw);
    if (renderer) renderer->render(*ImGui::GetDrawData(), Palette{}.background, ui.textures());
}

void HeadlessHost::frameWithoutDrawing(const std::function<void()>& draw) {
    layOut(draw);
}

Image HeadlessHost::readPixels() {
    if (!surface) throw std::logic_error("a host without GL has no pixels");
    surface->makeCurrent(pixelWidth, pixelHeight);
    return readFramebuffer(surface->gl, pixelWidth, pixelHeight);
}

void HeadlessHost::resize(int width, int height) {
    pixelWidth = sensibleSide(width);
    pixelHeight = sensibleSide(height);
}

}  // namespace halfdisk
