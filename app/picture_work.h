// What is a picture on its way? An estimator that was prepared, and the passes that it has made.
#pragma once

#include <atomic>
#include <memory>

#include "app/light_answer.h"
#include "core/estimator.h"

namespace halfdisk {

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
    std::uint32_t maxDepth_, maxSpecular_;
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

/// Gives the picture its colours, with so much light as white.
void tone(LightPicture& picture, double white);

/// What this picture alone would show as white; 0 if it is black.
double whiteOf(const LightPicture& picture);

}  // namespace halfdisk
