// Does a real window show what the headless host draws, and close when asked to? Needs a display: see
// with_xvfb.sh.
#include <doctest/doctest.h>

#include <csignal>

#include "app/headless_host.h"
#include "app/window_host.h"
#include "demo_panel.h"

using namespace halfdisk;

namespace {

std::unique_ptr<WindowHost> openWindow() {
    std::string whyNot;
    WindowOptions options;
    options.width = 1000;
    options.height = 700;
    auto window = WindowHost::open(options, whyNot);
    REQUIRE_MESSAGE(window, whyNot);
    return window;
}

}  // namespace

TEST_CASE("the window has the same pixels as the headless host") {
    Image onScreen;
    {
        const auto window = openWindow();
        DemoPanel panel;
        for (int i = 0; i < 3; ++i) {
            window->frame([&] { panel.draw(window->fonts()); });
            if (i < 2) window->present();
        }
        onScreen = window->readPixels();
    }
    HeadlessHost host(1000, 700);
    DemoPanel panel;
    for (int i = 0; i < 3; ++i) host.frame([&] { panel.draw(host.fonts()); });
    const ImageComparison result = compareImages(onScreen, host.readPixels(), 0);
    CHECK(result.outliers == 0);
    if (result.outliers > 0) writePng("window_difference.png", result.picture);
}

TEST_CASE("the window runs until it is closed") {
    const auto window = openWindow();
    DemoPanel panel;
    int frames = 0;
    window->run([&] {
        panel.draw(window->fonts());
        if (++frames == 5) window->close();
    });
    CHECK(frames == 5);
}

TEST_CASE("the window closes on SIGTERM and on SIGINT") {
    for (const int signal : {SIGTERM, SIGINT}) {
        const auto window = openWindow();
        int frames = 0;
        window->run([&] {
            if (++frames == 3) std::raise(signal);
        });
        CHECK(frames == 3);
    }
}

TEST_CASE("another scale rebuilds the window's fonts") {
    const auto window = openWindow();
    DemoPanel panel;
    window->frame([&] { panel.draw(window->fonts()); });
    const float before = panel.registry.find("Demo/Next")->rect.height();
    window->setUiScale(2.0f);
    for (int i = 0; i < 2; ++i) window->frame([&] { panel.draw(window->fonts()); });
    CHECK(panel.registry.find("Demo/Next")->rect.height() > 1.8f * before);
}

TEST_CASE("there is a display") {
    CHECK(hasDisplay());
}
