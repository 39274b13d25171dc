// How does a step become a picture without a display? The same frame as in the window, until its light is
// complete.
#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/cli_actions.h"
#include "app/cli_output.h"
#include "app/export_files.h"
#include "app/headless_host.h"
#include "app/light_progress.h"
#include "app/opening.h"
#include "app/picture.h"
#include "app/progress_bar.h"
#include "app/render_output.h"
#include "lessons/utf8.h"

namespace halfdisk {

namespace {

/// Bad input if it cannot be made, or if nothing can be written there.
void makeFolder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed || !std::filesystem::is_directory(folder, failed))
        throw InputError(fmt::format("--output: '{}' is no folder that can be made{}{}, expected a folder",
                                     excerpt(folder.string()), failed ? ": " : "",
                                     failed ? failed.message() : ""));
    refuseOutputs({folder / "screen.png"});
}

/// Tells on a terminal how far it is.
void waitForLight(Session& session) {
    ProgressBar bar;
    constexpr std::chrono::milliseconds kLook{100};
    const auto start = std::chrono::steady_clock::now();
    while (!session.light.waitUntilIdle(kLook)) {
        session.state.answer = session.light.latest();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        if (bar.isShown()) bar.tell(lightShare(session.state), elapsed.count(), lightParts(session.state));
    }
}

/// Throws where the light could not be computed.
void refuseFailed(const Session& session) {
    const auto answer = session.light.latest();
    if (answer && !answer->failure.empty()) throw std::runtime_error(answer->failure);
}

}  // namespace

std::vector<Image> picturesOf(AppState state, std::span<HeadlessHost* const> hosts) {
    Session session;
    session.state = std::move(state);
    askLight(session);
    session.light.waitUntilIdle();
    refuseFailed(session);
    std::vector<Image> images;
    for (HeadlessHost* host : hosts) {
        session.state.uiScale = host->uiScale();
        session.state.litLine = 0;  // the code scrolls to its line anew
        const auto draw = [&] { frame(session, host->fonts(), host->uiScale()); };
        // Dear ImGui sizes some windows by what they held in the frame before: a few frames until nothing
        // moves.
        constexpr int kSettleFrames = 4;
        for (int i = 0; i < kSettleFrames; ++i) host->frameWithoutDrawing(draw);
        host->frame(draw);
        images.push_back(host->readPixels());
    }
    return images;
}

Image pictureOf(AppState state, HeadlessHost& host) {
    HeadlessHost* const hosts[] = {&host};
    return std::move(picturesOf(std::move(state), hosts).front());
}

int runScreenshot(const ScreenshotRequest& request) {
    AppState state = openRequested(request.opening);
    refuseUnwritable(request.output);
    const auto scale = static_cast<float>(request.scale);
    state.uiScale = scale;
    HeadlessHost host(request.size.width, request.size.height, scale);
    writePng(request.output, pictureOf(std::move(state), host));
    return kExitSuccess;
}

int runExport(const ExportRequest& request) {
    AppState state = openRequested(request.opening);
    makeFolder(request.outputFolder);
    Session session;
    session.state = std::move(state);
    const auto scale = static_cast<float>(request.scale);
    session.state.uiScale = scale;
    HeadlessHost host(request.size.width, request.size.height, scale);
    askLight(session);
    waitForLight(session);
    refuseFailed(session);
    const FrameMaker maker{[&](const FrameMaker::Draw& draw) { host.frameWithoutDrawing(draw); },
                           [&](const FrameMaker::Draw& draw) { host.frame(draw); },
                           [&] { return host.readPixels(); }, [&]() -> const Fonts& { return host.fonts(); },
                           [&] { return host.uiScale(); }};
    const Seen seen = seenBy(session, maker);
    const std::vector<ExportFile> files = exportFiles(session.state, seen);
    writeExport(request.outputFolder, files);
    std::string names;
    for (const ExportFile& file : files) names += (request.outputFolder / file.name).string() + '\n';
    writeOutput(names);
    return kExitSuccess;
}

int runTour(const TourRequest& request) {
    makeFolder(request.outputFolder);
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
