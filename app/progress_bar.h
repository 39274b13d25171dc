// How far is the work, and how long will it still take? One line on a terminal that is written over.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace halfdisk {

/// `12 s`, `3 min 20 s`, `2 h 05 min`. At least 0.
std::string durationText(double seconds);

/// `[=====               ]  25 %  16 samples  12 s left`. fraction 0 ... 1; `elapsed` in seconds.
std::string progressLine(double fraction, double elapsed, std::string_view done);

/// Writes to stderr, and only if that is a terminal. May be told from any thread.
class ProgressBar {
 public:
    ProgressBar();
    ~ProgressBar();  ///< takes the line away
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    bool isShown() const { return shown_; }

    /// Drawn at once the first time, then ten times a second at most.
    void tell(double fraction, double elapsed, std::string_view done);

    /// A line that stays, above the bar.
    void say(std::string_view line);

 private:
    void write(const std::string& text);

    bool shown_;
    std::mutex mutex_;
    std::string last_;
    std::chrono::steady_clock::time_point next_{};
};

}  // namespace halfdisk
