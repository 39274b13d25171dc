// How does one picture grow? Its estimator is prepared, then come batches of passes.
#include "app/picture_work.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/false_color.h"
#include "app/light_answer.h"
#include "app/tone.h"
#include "core/estimators.h"
#include "core/render.h"
#include "core/stopwatch.h"

namespace halfdisk {
namespace {

// Of one picture: a second or two of one core, counted in what does not depend on the machine. The same for
// all, so that two that are compared cost the same. Some are done without rays.
constexpr std::uint64_t kMostPasses = 16'384, kMostPassesWithoutRays = 512;
constexpr std::uint64_t kMostRays = 1'200'000;
// Of each of two pictures that are to take as long.
constexpr double kMostSeconds = 1.0;
constexpr std::uint64_t kMostPassesInTime = 1u << 24;
// Of one batch, so that pictures follow each other fast.
constexpr double kPathsPerBatch = 16'384.0;

std::uint64_t scaled(std::uint64_t work, double effort) {
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(work) * effort));
}

std::uint64_t mostPasses(const Film& film, Budget budget, double effort) {
    if (budget == Budget::time) return kMostPassesInTime;
    return scaled(film.counts.rays > 0 || film.passes == 0 ? kMostPasses : kMostPassesWithoutRays, effort);
}

/// More at once as there are more: the first picture comes soon, and later ones are not copied for nothing.
std::uint64_t nextBatch(const Film& film, double pathsPerPass, Budget budget, double effort) {
    const auto usual = static_cast<std::uint64_t>(std::max(1.0, kPathsPerBatch / pathsPerPass));
    const std::uint64_t least = film.passes == 0 ? 1 : film.passes < usual ? usual - film.passes : usual;
    const std::uint64_t most = budget == Budget::time ? kMostPassesInTime : scaled(kMostPasses, effort);
    return std::min(std::max(least, film.passes / 2), most - film.passes);
}

/// The same, but for so many seconds at most, as far as the passes before can tell.
std::uint64_t batchWithin(double seconds, const LightPicture& picture, double pathsPerPass) {
    if (picture.film.passes == 0 || !(picture.passSeconds > 0.0)) return 1;
    const double fitting = seconds / (picture.passSeconds / static_cast<double>(picture.film.passes));
    const std::uint64_t usual = nextBatch(picture.film, pathsPerPass, Budget::time, 1.0);
    return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(std::clamp(fitting, 1.0, 1e9)), 1, usual);
}

/// In false colours, one for each place.
void toneFalsely(LightPicture& picture) {
    const PixelStatistics& pixels = picture.film.pixels;
    picture.logColors.clear();
    picture.noiseColors.clear();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Statistics pixel = pixels[i];
        const double light = gray(pixel.mean), error = gray(pixel.standardError());
        picture.logColors.push_back(decadeColor(picture.white > 0.0 ? light / picture.white : 0.0));
        // No light at all: nothing can be said.
        picture.noiseColors.push_back(light > 0.0 ? decadeColor(error / light) : packed(160, 160, 160));
    }
}

/// One alone spends rays.
Budget budgetOf(const LightQuestion& asked) {
    return asked.makers.second ? asked.makers.equal : Budget::rays;
}

}  // namespace

void tone(LightPicture& picture, double white) {
    const std::vector<Rgb>& means = picture.film.pixels.mean;
    const double scale = white > 0.0 ? 1.0 / white : 1.0;
    picture.white = white;
    picture.colors.clear();
    picture.colors.reserve(means.size());
    for (const Rgb& mean : means)
        picture.colors.push_back(
            packed(srgbByte(scale * mean.x), srgbByte(scale * mean.y), srgbByte(scale * mean.z)));
    if (std::holds_alternative<Field>(picture.sensor)) toneFalsely(picture);
}

double whiteOf(const LightPicture& picture) {
    const std::vector<Rgb>& means = picture.film.pixels.mean;
    const bool black = std::all_of(means.begin(), means.end(), [](const Rgb& c) { return c == Rgb(0.0); });
    return black ? 0.0 : 1.0 / automaticScale(means);
}

double shareDone(const LightPicture& picture, Budget budget, double effort) {
    if (picture.complete) return 1.0;
    const auto of = [](std::uint64_t done, std::uint64_t all) {
        return static_cast<double>(done) / static_cast<double>(all);
    };
    const double byPasses = of(picture.film.passes, mostPasses(picture.film, budget, effort));
    const double spent = budget == Budget::time ? picture.seconds / (effort * kMostSeconds)
                                                : of(picture.film.counts.rays, scaled(kMostRays, effort));
    return std::min(0.99, std::max(spent, byPasses));
}

PictureWork::PictureWork(const LightQuestion& asked, Sensor sensor, Maker maker,
                         const std::atomic<bool>& cancelled)
    : scene_(asked.scene),
      sensor_(std::move(sensor)),
      maker_(std::move(maker)),
      budget_(budgetOf(asked)),
      effort_(asked.effort),
      maxDepth_(maker_.depth.value_or(asked.settings.maxDepth)),
      maxSpecular_(maker_.specular.value_or(asked.settings.maxSpecular)),
      seed_(asked.settings.seed) {
    const Stopwatch watch;
    const EstimatorInfo& info = *findEstimator(maker_.estimator);
    const Problem problem{.index = scene_->index,
                          .sensor = sensor_,
                          .maxDepth = maxDepth_,
                          .maxSpecular = maxSpecular_,
                          .seed = seed_,
                          .stop = [&cancelled] { return cancelled.load(std::memory_order_relaxed); }};
    auto picture = std::make_shared<LightPicture>();
    picture->sensor = sensor_;
    picture->refusal = refusalOf(info, problem, maker_.params);
    try {
        if (picture->refusal.empty()) estimator_ = info.make(problem, maker_.params);
    } catch (const std::invalid_argument& refused) {
        picture->refusal = refused.what();
    }
    picture->complete = !estimator_;
    picture->seconds = watch.seconds();
    picture_ = std::move(picture);
}

bool PictureWork::answers(const LightQuestion& question, const Maker& maker) const {
    const auto* profile = std::get_if<Profile>(&sensor_);
    return maker_ == maker && budget_ == budgetOf(question) && effort_ == question.effort &&
           (!profile || profile->segments.front() == question.at.segment) && scene_ == question.scene &&
           maxDepth_ == maker.depth.value_or(question.settings.maxDepth) &&
           maxSpecular_ == maker.specular.value_or(question.settings.maxSpecular) &&
           seed_ == question.settings.seed;
}

bool PictureWork::addBatch() {
    auto next = std::make_shared<LightPicture>(*picture_);
    const bool byTime = budget_ == Budget::time;
    RenderOptions options;
    options.firstPass = next->film.passes;
    const double pathsPerPass = pixelCount(sensor_) + estimator_->workPerPass();
    options.passes = byTime ? batchWithin(effort_ * kMostSeconds - next->seconds, *next, pathsPerPass)
                            : nextBatch(next->film, pathsPerPass, budget_, effort_);
    const Stopwatch watch;
    const Film batch = render(*estimator_, sensor_, options);
    const double took = watch.seconds();
    if (batch.passes < options.passes) return false;
    next->film.merge(batch);
    next->seconds += took;
    next->passSeconds += took;
    const bool spent = byTime ? next->seconds >= effort_ * kMostSeconds
                              : next->film.counts.rays >= scaled(kMostRays, effort_);
    next->complete = spent || next->film.passes >= mostPasses(next->film, budget_, effort_);
    next->noise = noiseOf(*next);
    if (!std::holds_alternative<Profile>(sensor_)) tone(*next, whiteOf(*next));
    picture_ = std::move(next);
    return true;
}

}  // namespace halfdisk
