// Does the real program open its window at the first lesson, look as it does without a display, and close
// when it is asked to? Needs a display: see with_xvfb.sh.
#include <doctest/doctest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>

#include "app/picture.h"
#include "app/window_host.h"
#include "golden.h"
#include "rig.h"
#include "x_client.h"

using namespace halfdisk;

namespace {

constexpr int kPatience = 60;  // s; only a failing test waits this long

/// Looks again and again until `done`; false when patience ends.
bool eventually(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kPatience);
    while (!done()) {
        if (std::chrono::steady_clock::now() > end) return false;
        ::poll(nullptr, 0, 20);  // leaves the processor to the program
    }
    return true;
}

/// The program, started like a user would; ended at the latest with this.
class Program {
 public:
    Program() : pid_(::fork()) {
        if (pid_ != 0) return;
        ::execl(HALFDISK_PROGRAM, HALFDISK_PROGRAM, static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ~Program() {
        if (status_) return;
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void signal(int number) const { ::kill(pid_, number); }
    bool hasEnded() {
        int status = 0;
        if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_) status_ = status;
        return status_.has_value();
    }
    /// Waits for its end. -1 if it does not end by itself, or is ended by a signal.
    int exitCode() {
        if (!eventually([this] { return hasEnded(); }) || !WIFEXITED(*status_)) return -1;
        return WEXITSTATUS(*status_);
    }

 private:
    pid_t pid_;
    std::optional<int> status_;
};

bool hasSeveralColors(const Image& image) {
    const std::uint8_t* first = image.at(0, 0);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        if (!std::equal(first, first + 3, image.rgba.begin() + static_cast<std::ptrdiff_t>(i))) return true;
    return false;
}

/// Its window, once something is drawn in it.
XClient::Window windowOf(Program& program, const XClient& x) {
    std::optional<XClient::Window> window;
    const bool found = eventually([&] {
        REQUIRE_MESSAGE(!program.hasEnded(), "the program ended before its window was there");
        window = x.find("Halfdisk");
        const auto picture = window ? x.picture(*window) : std::nullopt;
        return picture && hasSeveralColors(*picture);
    });
    REQUIRE_MESSAGE(found, "the program shows no window");
    return *window;
}

Image firstStepWithoutDisplay() {
    HeadlessHost host(kGoldenWidth, kGoldenHeight);
    return pictureOf(openLesson(courseLessons(), std::nullopt), host);
}

void keep(const char* name, const Image& image) {
    writePng(std::filesystem::path(HALFDISK_DIFFERENCES).parent_path() / name, image);
}

}  // namespace

TEST_CASE("the first step of the first lesson has the same pixels in a window as without a display") {
    XClient().movePointerAway();
    Image onScreen;
    {
        std::string whyNot;
        const auto window = WindowHost::open({}, whyNot);
        REQUIRE_MESSAGE(window, whyNot);
        Session session;
        session.state = openLesson(courseLessons(), std::nullopt);
        askLight(session);
        session.light.waitUntilIdle();
        constexpr int kFrames = 5;
        for (int i = 0; i < kFrames; ++i) {
            window->frame([&] { frame(session, window->fonts(), window->fullScale()); });
            if (i + 1 < kFrames) window->present();
        }
        onScreen = window->readPixels();
    }
    const ImageComparison compared = compareImages(onScreen, firstStepWithoutDisplay(), 0);
    CHECK(compared.outliers == 0);
    if (compared.outliers > 0) keep("session_difference.png", compared.picture);
}

TEST_CASE("the program shows the first lesson and ends with 0 when its window is closed") {
    XClient x;
    x.movePointerAway();
    Program program;
    const XClient::Window window = windowOf(program, x);
    const Image expected = firstStepWithoutDisplay();
    std::optional<Image> shown;
    const bool same = eventually([&] {
        shown = x.picture(window);
        return shown && matches(*shown, expected);
    });
    CHECK_MESSAGE(same, "the window does not show the first step as it looks without a display");
    if (!same && shown) keep("program_shows.png", *shown);
    CHECK_FALSE(program.hasEnded());
    x.askToClose(window);
    CHECK(program.exitCode() == 0);
}

TEST_CASE("the program ends with 0 on SIGTERM and on SIGINT") {
    const XClient x;
    for (const int number : {SIGTERM, SIGINT}) {
        CAPTURE(number);
        Program program;
        windowOf(program, x);
        program.signal(number);
        CHECK(program.exitCode() == 0);
    }
}
