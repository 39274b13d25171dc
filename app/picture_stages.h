// In which order do the eye's strip and the field grow behind the frame? Batch by batch of passes, each one
// whole.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "app/light_answer.h"
#include "core/estimator.h"

namespace halfdisk {

/// A picture on its way. It does not depend on P or N: it is kept while only those change.
class PictureWork {
 public:
    /// Prepares the estimator; what cannot be done is told by the picture's refusal. `cancelled` outlives it,
    /// and calls off whatever is under way. Throws Stopped if that is set here already.
    PictureWork(std::shared_ptr<const PreparedScene> scene, Sensor sensor, const char* estimator,
                const Settings& settings, const std::atomic<bool>& cancelled);
    PictureWork(const PictureWork&) = delete;  // the estimator refers to the sensor
    PictureWork& operator=(const PictureWork&) = delete;

    bool answers(const LightQuestion& question) const;

    /// Adds the next batch of passes. False, and nothing is added, if cancelled on the way: the same passes
    /// always give the same bits.
    bool addBatch();

    const std::shared_ptr<const LightPicture>& picture() const { return picture_; }

 private:
    std::shared_ptr<const PreparedScene> scene_;
    Sensor sensor_;
    std::uint32_t maxDepth_;
    std::uint64_t seed_;
    std::unique_ptr<Estimator> estimator_;
    std::shared_ptr<const LightPicture> picture_;
};

struct PictureCache {
    std::unique_ptr<PictureWork> eye, field;
};

/// The pictures as far as they are done already, and none that answers another question.
void recallPictures(LightAnswer& answer, PictureCache& cache);

/// Stage 4: renders what the question wants; calls `publish` after each batch.
void refinePictures(LightAnswer& answer, PictureCache& cache, const std::atomic<bool>& cancelled,
                    const std::function<void()>& publish);

}  // namespace halfdisk
