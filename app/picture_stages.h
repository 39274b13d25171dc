// In which order do the pictures grow behind the frame? Batch by batch of passes, each one whole, all
// pictures in turn.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>

#include "app/light_answer.h"
#include "app/strategy_work.h"
#include "core/estimator.h"

namespace halfdisk {

/// Those that an estimator makes.
inline constexpr std::array kPictureViews{View::profile, View::eye, View::field};

/// What makes this picture if nothing is said.
Maker usualMaker(View view);

/// What is looked at; nothing if the scene has no eye.
std::optional<Sensor> sensorOf(View view, const LightQuestion& asked);

/// What is asked to make this picture, the first (0) or the second (1) maker; nothing if it is not wanted.
std::optional<Maker> makerAsked(const LightQuestion& asked, View view, std::size_t side);

/// How much of a picture's work is done, 0 ... 1.
double shareDone(const LightPicture& picture, Budget budget, double effort);

/// A picture on its way. It is kept while only P (but for the profile's wall) and N change.
class PictureWork {
 public:
    /// Prepares the estimator; what cannot be done is told by the picture's refusal. `cancelled` outlives it,
    /// and calls off whatever is under way. Throws Stopped if that is set here already.
    PictureWork(const LightQuestion& asked, Sensor sensor, Maker maker, const std::atomic<bool>& cancelled);
    PictureWork(const PictureWork&) = delete;  // the estimator refers to the sensor
    PictureWork& operator=(const PictureWork&) = delete;

    bool answers(const LightQuestion& question, const Maker& maker) const;

    /// Adds the next batch of passes. False, and nothing is added, if cancelled on the way: the same passes
    /// always give the same bits. How many there will be depends on the machine where time is the budget.
    bool addBatch();

    const std::shared_ptr<const LightPicture>& picture() const { return picture_; }

 private:
    std::shared_ptr<const PreparedScene> scene_;
    Sensor sensor_;
    Maker maker_;
    Budget budget_;
    double effort_;
    std::uint32_t maxDepth_;
    std::uint64_t seed_;
    std::unique_ptr<Estimator> estimator_;
    std::shared_ptr<const LightPicture> picture_;
};

/// Light that was followed. It is kept while only P and N change.
struct FollowedWays {
    std::shared_ptr<const PreparedScene> scene;
    std::uint32_t maxDepth = 0;
    std::uint64_t seed = 0;
    std::shared_ptr<const std::vector<LightWay>> ways{};
    std::vector<std::pair<std::string, std::size_t>> words{};
    std::optional<std::size_t> throughPupil{};
    std::shared_ptr<const RayCloud> cloud{};
};

struct PictureCache {
    /// By kPictureViews; the first maker's and the second's.
    std::array<std::array<std::unique_ptr<PictureWork>, 2>, kPictureViews.size()> works;
    std::unique_ptr<StrategyWork> strategies;
    std::optional<FollowedWays> ways;
};

/// The pictures as far as they are done already, and none that answers another question.
void recallPictures(LightAnswer& answer, PictureCache& cache);

/// Stage 4: renders what the question wants; calls `publish` after each batch. At most `turns` batches of
/// each.
void refinePictures(LightAnswer& answer, PictureCache& cache, const std::atomic<bool>& cancelled,
                    const std::function<void()>& publish, unsigned turns);

}  // namespace halfdisk
