#include "app/light_job.h"

#include <climits>
#include <new>
#include <utility>
#include <vector>

#include "app/instrument_stages.h"
#include "app/light_stages.h"
#include "app/picture_stages.h"

namespace halfdisk {

struct LightJob::Caches {
    ReferenceCache references;
    PictureCache pictures;
    InstrumentCache instruments;
    /// Every record is held here as well, so that its megabytes are given back on this thread, not within a
    /// frame.
    std::vector<std::shared_ptr<const void>> records;
    /// All but the instruments, of the last question whose light was finished.
    std::optional<LightAnswer> settled;
};

namespace {

/// Another wish of the trade changes nothing else.
bool differInWish(LightQuestion a, const LightQuestion& b) {
    a.id = b.id;
    a.instrumentSettings.wish = b.instrumentSettings.wish;
    a.instrumentSettings.wishedError = b.instrumentSettings.wishedError;
    a.instrumentSettings.wishedMilliseconds = b.instrumentSettings.wishedMilliseconds;
    a.instrumentSettings.tradeCost = b.instrumentSettings.tradeCost;
    return a == b;
}

}  // namespace

LightJob::LightJob() : thread_([this] { run(); }) {}

LightJob::~LightJob() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
        cancelled_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void LightJob::ask(LightQuestion question) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(question);
        if (!finishingFirstPicture_) cancelled_ = true;
    }
    changed_.notify_all();
}

std::shared_ptr<const LightAnswer> LightJob::latest() const {
    const std::lock_guard lock(mutex_);
    return latest_;
}

bool LightJob::idle() const {
    const std::lock_guard lock(mutex_);
    return !waiting_ && !working_;
}

void LightJob::waitUntilIdle() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !waiting_ && !working_; });
}

bool LightJob::waitUntilIdle(std::chrono::milliseconds most) const {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, most, [this] { return !waiting_ && !working_; });
}

void LightJob::publish(const LightAnswer& answer) {
    auto copy = std::make_shared<const LightAnswer>(answer);
    const std::lock_guard lock(mutex_);
    latest_ = std::move(copy);
}

void LightJob::answerAll(LightAnswer& answer, Caches& caches) {
    const auto superseded = [&] {
        const std::lock_guard guard(mutex_);
        return waiting_.has_value() || quit_;
    };
    const auto publishNow = [&] { publish(answer); };
    if (caches.settled && differInWish(caches.settled->asked, answer.asked)) {
        const LightQuestion asked = std::move(answer.asked);
        answer = *caches.settled;
        answer.asked = asked;
        finishingFirstPicture_ = false;
        recallInstruments(answer, caches.instruments);
        publishNow();
    } else {
        caches.settled.reset();
        answerLight(answer, caches, superseded);
        if (!superseded()) caches.settled = answer;
    }
    if (!superseded()) measureInstruments(answer, caches.instruments, cancelled_, publishNow);
    if (!superseded()) {
        answer.complete = true;
        publishNow();
    }
}

void LightJob::answerLight(LightAnswer& answer, Caches& caches, const std::function<bool()>& superseded) {
    std::erase_if(caches.records, [](const auto& record) { return record.use_count() == 1; });
    recordRun(answer, cancelled_);
    recordPathRun(answer, cancelled_);
    if (answer.record) caches.records.push_back(answer.record);
    if (answer.pathRun) caches.records.push_back(answer.pathRun);
    if (hasQuickCloud(answer)) makeTreeCloud(answer, cancelled_);
    finishingFirstPicture_ = false;
    recallPictures(answer, caches.pictures);
    recallInstruments(answer, caches.instruments);
    if (!cancelled_) publish(answer);
    const auto publishNow = [&] { publish(answer); };
    if (!superseded() && answer.asked.instruments.has(View::extremes)) {
        answerDial(answer, caches.instruments, cancelled_);
        publishNow();
    }
    if (answer.treeLines && !superseded()) {
        makeTreeCloud(answer, cancelled_);
        publish(answer);
    }
    if (answer.tree) caches.records.push_back(answer.tree);
    // First pictures at once, for what is exactly known may take a while.
    if (!superseded()) refinePictures(answer, caches.pictures, cancelled_, publishNow, 1);
    if (!superseded() && answer.asked.instruments.has(View::requirements)) {
        answerRequirements(answer, caches.instruments, cancelled_);
        publishNow();
    }
    if (!superseded()) refine(answer, caches.references, cancelled_, publishNow);
    if (!superseded()) findExactPictures(answer, caches.references, cancelled_);
    if (!superseded()) refinePictures(answer, caches.pictures, cancelled_, publishNow, UINT_MAX);
}

void LightJob::run() {
    Caches caches;
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return quit_ || waiting_; });
        if (quit_) return;
        LightAnswer answer;
        answer.asked = *std::exchange(waiting_, std::nullopt);
        working_ = true;
        cancelled_ = false;
        finishingFirstPicture_ = isQuick(answer.asked);
        lock.unlock();

        try {
            answerAll(answer, caches);
        } catch (const std::bad_alloc&) {
            // What was kept is given back first; the window lives on, and says why.
            const LightQuestion asked = answer.asked;
            caches = {};
            answer = {};
            answer.asked = asked;
            answer.failure = "there is not enough memory for this light";
            answer.complete = true;
            publish(answer);
        }

        lock.lock();
        working_ = false;
        changed_.notify_all();
    }
}

}  // namespace halfdisk
