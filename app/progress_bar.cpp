// How far is the work, and how long will it still take? One line on a terminal that is written over.
#include "app/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace halfdisk {
namespace {

constexpr std::size_t kBarCells = 20;
constexpr auto kLeastPause = std::chrono::milliseconds(100);
constexpr std::string_view kClearLine = "\r\x1b[K";

}  // namespace

std::string durationText(double seconds) {
    constexpr double kMostShown = 3.6e8;  // a hundred thousand hours
    const auto whole = static_cast<long>(std::ceil(std::clamp(seconds, 0.0, kMostShown)));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string progressLine(double fraction, double elapsed, std::string_view done) {
    fraction = std::clamp(fraction, 0.0, 1.0);
    const auto cells = static_cast<std::size_t>(fraction * kBarCells);
    std::string line = fmt::format("[{}{}] {:3.0f} %  {}", std::string(cells, '='),
                                   std::string(kBarCells - cells, ' '), std::floor(100.0 * fraction), done);
    if (fraction > 0.0) line += fmt::format("  {} left", durationText(elapsed * (1.0 - fraction) / fraction));
    return line;
}

ProgressBar::ProgressBar() : shown_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (!last_.empty()) write(std::string(kClearLine));
}

void ProgressBar::tell(double fraction, double elapsed, std::string_view done) {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + kLeastPause;
    last_ = progressLine(fraction, elapsed, done);
    write(std::string(kClearLine) + last_);
}

void ProgressBar::say(std::string_view line) {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    write(fmt::format("{}{}\n{}", kClearLine, line, last_));
}

void ProgressBar::write(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace halfdisk
