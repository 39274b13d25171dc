// Which running program do the tests of the window operate? All of it, without OpenGL and without a clock.
#include "rig.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace halfdisk {

std::filesystem::path testLessons() {
    return std::filesystem::path(HALFDISK_ROOT) / "tests/app/data/lessons";
}

std::filesystem::path courseLessons() {
    return std::filesystem::path(HALFDISK_ROOT) / "lessons";
}

Rig::Rig(AppState opened, int width, int height)
    : host(HeadlessHost::withoutGl(width, height)), driver{*host, session.widgets, [this] {
                                                               frame(session, host->fonts(), host->uiScale());
                                                               host->setUiScale(session.state.uiScale);
                                                           }} {
    session.state = std::move(opened);
    session.effort = kQuick;
    settle();
}

Rig::Rig(std::string_view lesson, int width, int height)
    : Rig(openLesson(testLessons(), parseLessonRef(lesson)), width, height) {}

void Rig::setEffort(double effort) {
    session.effort = effort;
    ++session.state.questionId;
    settle();
}

void Rig::settle() {
    driver.frames();
    session.light.waitUntilIdle();
    driver.frames(2);
}

void Rig::apply(const Command& command) {
    halfdisk::apply(session.state, command);
    driver.frames();
}

CanvasRect Rig::canvas() {
    const Rect rect = driver.get("Stage/canvas").rect;
    return {{rect.left, rect.top}, {rect.right, rect.bottom}};
}

ImVec2 Rig::screen(Vec2 point) {
    return toScreen(state().camera, canvas(), point);
}

Vec2 Rig::world(ImVec2 point) {
    return toWorld(state().camera, canvas(), point);
}

void Rig::scrollTo(std::string_view name, std::string_view beside) {
    constexpr int kMostNotches = 60;
    for (const Widget& widget : session.widgets.widgets) {
        if (widget.name.rfind(beside, 0) != 0 || widget.target.height() < 0.9f * widget.rect.height())
            continue;
        driver.moveTo(widget.target.centerX(), widget.target.centerY());
        break;
    }
    for (const float up : {-1.0f, 1.0f}) {
        for (int notch = 0; notch < kMostNotches; ++notch) {
            const Widget widget = driver.get(name);
            if (widget.target.height() > 0.9f * widget.rect.height()) return;
            host->queue(MouseWheel{up, 0});
            driver.frames(2);
        }
    }
    throw std::runtime_error(fmt::format("{} cannot be scrolled into view", name));
}

LessonsCopy::LessonsCopy() {
    const auto temporary = std::filesystem::temp_directory_path();
    for (int attempt = 0; folder.empty(); ++attempt) {
        const auto candidate = temporary / fmt::format("halfdisk lessons {} {}", ::getpid(), attempt);
        if (std::filesystem::create_directory(candidate)) folder = candidate;
    }
    std::filesystem::copy(testLessons(), folder, std::filesystem::copy_options::recursive);
    newest_ = std::filesystem::last_write_time(folder);
}

LessonsCopy::~LessonsCopy() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
}

std::string LessonsCopy::read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder / name, std::ios::binary).rdbuf();
    return text.str();
}

void LessonsCopy::write(const std::string& name, std::string_view text) {
    std::ofstream(folder / name, std::ios::binary) << text;
    newest_ += std::chrono::seconds(2);
    std::filesystem::last_write_time(folder / name, newest_);
}

}  // namespace halfdisk
