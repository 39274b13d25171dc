// In which order do the pictures grow behind the frame? Batch by batch of passes, each one whole, all
// pictures in turn.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>

#include "app/light_answer.h"
#include "app/picture_work.h"
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
