// In which order do the eye's strip and the field grow behind the frame? Batch by batch of passes, each one
// whole.
#include "app/picture_stages.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/tone.h"
#include "core/estimators.h"
#include "core/render.h"

namespace halfdisk {
namespace {

// Of one picture: a second or two of one core, counted in what does not depend on the machine.
constexpr std::uint64_t kMostPasses = 512;
constexpr std::uint64_t kMostRays = 1'200'000;
// Of one batch, so that pictures follow each other fast.
constexpr double kPathsPerBatch = 16'384.0;

/// More at once as there are more: the first picture comes soon, and later ones are not copied for nothing.
std::uint64_t nextBatch(const Film& film, double pathsPerPass) {
    const auto least = static_cast<std::uint64_t>(std::max(1.0, kPathsPerBatch / pathsPerPass));
    return std::min(std::max(least, film.passes / 2), kMostPasses - film.passes);
}

std::uint32_t packed(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    return 0xff000000u | static_cast<std::uint32_t>(blue) << 16 | static_cast<std::uint32_t>(green) << 8 |
           red;
}

void tone(LightPicture& picture) {
    const std::vector<Rgb>& means = picture.film.pixels.mean;
    const double scale = automaticScale(means);
    picture.white = 1.0 / scale;
    picture.colors.clear();
    picture.colors.reserve(means.size());
    for (const Rgb& mean : means)
        picture.colors.push_back(
            packed(srgbByte(scale * mean.x), srgbByte(scale * mean.y), srgbByte(scale * mean.z)));
}

/// `work` as it must be to answer `asked`: made anew unless it does already. None if cancelled on the way.
void prepare(std::unique_ptr<PictureWork>& work, const LightQuestion& asked,
             const std::optional<Sensor>& sensor, const char* estimator, const std::atomic<bool>& cancelled) {
    if (work && work->answers(asked)) return;
    work.reset();
    if (!sensor) return;
    try {
        work = std::make_unique<PictureWork>(asked.scene, *sensor, estimator, asked.settings, cancelled);
    } catch (const Stopped&) {
    }
}

}  // namespace

PictureWork::PictureWork(std::shared_ptr<const PreparedScene> scene, Sensor sensor, const char* estimator,
                         const Settings& settings, const std::atomic<bool>& cancelled)
    : scene_(std::move(scene)),
      sensor_(std::move(sensor)),
      maxDepth_(settings.maxDepth),
      seed_(settings.seed) {
    const EstimatorInfo& info = *findEstimator(estimator);
    const Problem problem{.index = scene_->index,
                          .sensor = sensor_,
                          .maxDepth = maxDepth_,
                          .seed = seed_,
                          .stop = [&cancelled] { return cancelled.load(std::memory_order_relaxed); }};
    const ParamValues params = initialValues(info);
    auto picture = std::make_shared<LightPicture>();
    picture->sensor = sensor_;
    picture->refusal = refusalOf(info, problem, params);
    try {
        if (picture->refusal.empty()) estimator_ = info.make(problem, params);
    } catch (const std::invalid_argument& refused) {
        picture->refusal = refused.what();
    }
    picture->complete = !estimator_;
    picture_ = std::move(picture);
}

bool PictureWork::answers(const LightQuestion& question) const {
    return scene_ == question.scene && maxDepth_ == question.settings.maxDepth &&
           seed_ == question.settings.seed;
}

bool PictureWork::addBatch() {
    auto next = std::make_shared<LightPicture>(*picture_);
    RenderOptions options;
    options.firstPass = next->film.passes;
    options.passes = nextBatch(next->film, pixelCount(sensor_) + estimator_->workPerPass());
    const Film batch = render(*estimator_, sensor_, options);
    if (batch.passes < options.passes) return false;
    next->film.merge(batch);
    next->complete = next->film.passes >= kMostPasses || next->film.counts.rays >= kMostRays;
    tone(*next);
    picture_ = std::move(next);
    return true;
}

void recallPictures(LightAnswer& answer, PictureCache& cache) {
    const LightQuestion& asked = answer.asked;
    if (asked.wantsEye && cache.eye && cache.eye->answers(asked)) answer.eye = cache.eye->picture();
    if (asked.wantsField && cache.field && cache.field->answers(asked)) answer.field = cache.field->picture();
}

void refinePictures(LightAnswer& answer, PictureCache& cache, const std::atomic<bool>& cancelled,
                    const std::function<void()>& publish) {
    const LightQuestion& asked = answer.asked;
    const Bounds& bounds = asked.scene->bounds;
    if (asked.wantsEye) prepare(cache.eye, asked, eyeStripOf(asked.scene->scene), "path", cancelled);
    if (asked.wantsField) prepare(cache.field, asked, fieldOf(bounds.min, bounds.max), "light", cancelled);
    const auto grow = [&](const std::unique_ptr<PictureWork>& work,
                          std::shared_ptr<const LightPicture>& shown) {
        if (!work) return;
        shown = work->picture();
        while (!shown->complete && !cancelled) {
            if (!work->addBatch()) return;
            shown = work->picture();
            publish();
        }
    };
    if (asked.wantsEye) grow(cache.eye, answer.eye);
    if (asked.wantsField) grow(cache.field, answer.field);
}

}  // namespace halfdisk
