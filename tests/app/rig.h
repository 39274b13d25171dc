// Which running program do the tests of the window operate? All of it, without OpenGL and without a clock.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/commands.h"
#include "app/frame.h"
#include "app/headless_host.h"
#include "driver.h"

namespace halfdisk {

/// Lessons made for tests, which stay as they are while those of the course change.
std::filesystem::path testLessons();
/// The lessons of the course.
std::filesystem::path courseLessons();

/// A session on a host without GL, and the driver that operates it.
struct Rig {
    std::unique_ptr<HeadlessHost> host;
    Session session;
    Driver driver;

    /// A sixteenth of the usual work, unless more is asked for: enough for all but the tests of how good
    /// answers are.
    static constexpr double kQuick = 1.0 / 16.0;

    explicit Rig(AppState opened, int width = 1280, int height = 800);
    /// At a step of a test lesson, such as "controls:2". The light is complete and shown.
    explicit Rig(std::string_view lesson, int width = 1280, int height = 800);
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;

    /// From now on answers get so much of their usual work. Waits until they have it.
    void setEffort(double effort);
    /// Waits until the light is complete, without a sleep, and shows it.
    void settle();

    const AppState& state() const { return session.state; }
    Settings& settings() { return session.state.settings; }
    void apply(const Command& command);  ///< between frames; then one frame

    CanvasRect canvas();
    ImVec2 screen(Vec2 world);  ///< where the canvas shows it
    Vec2 world(ImVec2 screen);  ///< what the canvas shows there

    /// Turns the wheel until `name` can be clicked, over a widget that is in sight and whose name starts with
    /// `beside`. Throws if it never can.
    void scrollTo(std::string_view name, std::string_view beside);
};

/// A copy of the test lessons that a test may change; removed at the end.
struct LessonsCopy {
    std::filesystem::path folder;

    LessonsCopy();
    ~LessonsCopy();
    LessonsCopy(const LessonsCopy&) = delete;
    LessonsCopy& operator=(const LessonsCopy&) = delete;

    std::string read(const std::string& name) const;
    /// Writes a file and makes it newer than all that were written before.
    void write(const std::string& name, std::string_view text);

 private:
    std::filesystem::file_time_type newest_;
};

}  // namespace halfdisk
