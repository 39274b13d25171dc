// How does the light get computed while the frame goes on? One thread, always at the latest question.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "app/light_answer.h"

namespace halfdisk {

class LightJob {
 public:
    LightJob();
    ~LightJob();
    LightJob(const LightJob&) = delete;
    LightJob& operator=(const LightJob&) = delete;

    /// Replaces the question. Never waits. A first picture that is cheap is still finished, so that dragging
    /// P shows pictures all the while; anything longer is given up at once.
    void ask(LightQuestion question);

    /// The newest answer, perhaps to an earlier question and not complete; null before the first.
    std::shared_ptr<const LightAnswer> latest() const;

    /// True when the last question is answered completely.
    bool idle() const;
    /// For hosts that need a finished picture.
    void waitUntilIdle() const;
    /// So long at most; whether it is idle then.
    bool waitUntilIdle(std::chrono::milliseconds most) const;

 private:
    struct Caches;

    void run();
    void answerAll(LightAnswer& answer, Caches& caches);
    /// All but the instruments.
    void answerLight(LightAnswer& answer, Caches& caches, const std::function<bool()>& superseded);
    void publish(const LightAnswer& answer);

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::optional<LightQuestion> waiting_;
    std::shared_ptr<const LightAnswer> latest_;
    bool working_ = false;
    bool quit_ = false;
    std::atomic<bool> cancelled_{false};
    std::atomic<bool> finishingFirstPicture_{false};
    std::thread thread_;
};

}  // namespace halfdisk
