// How does a step become a picture without a display? The same frame as in the window, until its light is
// complete.
#include <fmt/format.h>

#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/cli_actions.h"
#include "app/commands.h"
#include "app/frame.h"
#include "app/headless_host.h"
#include "app/opening.h"
#include "app/picture.h"
#include "app/png_image.h"

namespace halfdisk {

Image pictureOf(AppState state, HeadlessHost& host) {
    Session session;
    session.state = std::move(state);
    const auto draw = [&] { frame(session, host.fonts(), host.uiScale()); };
    askLight(session);
    session.light.waitUntilIdle();
    // Dear ImGui sizes some windows by what they held in the frame before: a few frames until nothing moves.
    constexpr int kSettleFrames = 4;
    for (int i = 0; i < kSettleFrames; ++i) host.frameWithoutDrawing(draw);
    host.frame(draw);
    return host.readPixels();
}

int runScreenshot(const ScreenshotRequest& request) {
    AppState state =
        openLesson(request.lessonsFolder, request.lesson, request.scene.value_or(std::filesystem::path()));
    setLanguage(state, request.language);
    const auto scale = static_cast<float>(request.scale);
    state.uiScale = scale;
    HeadlessHost host(request.size.width, request.size.height, scale);
    writePng(request.output, pictureOf(std::move(state), host));
    return kExitSuccess;
}

int runTour(const TourRequest& request) {
    std::error_code failed;
    std::filesystem::create_directories(request.outputFolder, failed);
    if (failed)
        throw std::runtime_error(fmt::format("{}: the folder cannot be made: {}",
                                             request.outputFolder.string(), failed.message()));
    const PictureSize size;
    bool broken = false;
    for (const LessonEntry& entry : listLessons(request.lessonsFolder)) {
        if (!entry.error.empty()) {
            fmt::print(stderr, "{}\n", entry.error);
            broken = true;
            continue;
        }
        for (int step = 1; step <= entry.steps; ++step) {
            HeadlessHost host(size.width, size.height);
            const auto file = request.outputFolder / fmt::format("{}-{}.png", entry.slug, step);
            AppState state = openLesson(request.lessonsFolder, LessonRef{entry.slug, step});
            setLanguage(state, request.language);
            writePng(file, pictureOf(std::move(state), host));
            fmt::print("{}\n", file.string());
        }
    }
    return broken ? kExitBadInput : kExitSuccess;
}

}  // namespace halfdisk
