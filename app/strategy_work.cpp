#include "app/strategy_work.h"

#include <algorithm>
#include <stdexcept>

#include "app/false_color.h"
#include "app/tone.h"
#include "core/estimators.h"

namespace halfdisk {
namespace {

// A second or two of one core, as of the other pictures (picture_stages.cpp).
constexpr std::uint64_t kMostPasses = 16'384, kMostRays = 1'200'000;
constexpr double kPathsPerBatch = 8192.0;
// Small strips need few pixels, and are the sooner without noise.
constexpr std::uint32_t kPixels = 96;
// Of the estimator's parameters, the strategies are all asked; of the others the maker decides.
constexpr std::array<std::string_view, 3> kOwnParams{"s", "t", "weights"};

/// The pictures' own maker, if it is bidirectional: its heuristic, roulette, depth and specular.
Maker makerFor(const LightQuestion& asked) {
    const EstimatorInfo& info = *findEstimator("bidirectional");
    Maker maker = makerOf(info.id);
    if (asked.makers.first && asked.makers.first->estimator == info.id) maker = *asked.makers.first;
    const ParamValues initial = initialValues(info);
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (std::find(kOwnParams.begin(), kOwnParams.end(), info.params[i].name) != kOwnParams.end())
            maker.params[i] = initial[i];
    maker.depth = maker.depth.value_or(asked.settings.maxDepth);
    maker.specular = maker.specular.value_or(asked.settings.maxSpecular);
    return maker;
}

Sensor sensorOf(const LightQuestion& asked) {
    if (const auto& eye = asked.scene->scene.eye) return EyeStrip{*eye, kPixels};
    return Profile{{asked.at.segment}, kPixels};
}

std::vector<std::uint32_t> tonedBy(double white, const std::vector<Rgb>& means) {
    const double scale = white > 0.0 ? 1.0 / white : 1.0;
    std::vector<std::uint32_t> colors;
    colors.reserve(means.size());
    for (const Rgb& mean : means)
        colors.push_back(
            packed(srgbByte(scale * mean.x), srgbByte(scale * mean.y), srgbByte(scale * mean.z)));
    return colors;
}

void tone(StrategyGrid& grid) {
    const std::vector<Rgb>& means = grid.film.whole.pixels.mean;
    const bool black = std::all_of(means.begin(), means.end(), [](const Rgb& c) { return c == Rgb(0.0); });
    grid.white = black ? 0.0 : 1.0 / automaticScale(means);
    grid.weightedColors = tonedBy(grid.white, grid.film.weighted.mean);
    grid.aloneColors = tonedBy(grid.white, grid.film.alone.mean);
}

}  // namespace

double StrategyGrid::share(std::size_t place, bool alone) const {
    const double all = gray(film.wholeMean.mean[0]);
    return all > 0.0 ? gray(means(alone).mean[place]) / all : 0.0;
}

double shareDone(const StrategyGrid& grid, double effort) {
    if (grid.complete) return 1.0;
    const auto of = [effort](std::uint64_t done, std::uint64_t all) {
        return static_cast<double>(done) / (effort * static_cast<double>(all));
    };
    return std::min(
        0.99, std::max(of(grid.film.whole.counts.rays, kMostRays), of(grid.film.whole.passes, kMostPasses)));
}

StrategyWork::StrategyWork(const LightQuestion& asked, const std::atomic<bool>& cancelled)
    : scene_(asked.scene),
      sensor_(sensorOf(asked)),
      maker_(makerFor(asked)),
      seed_(asked.settings.seed),
      effort_(asked.effort) {
    const Problem problem{.index = scene_->index,
                          .sensor = sensor_,
                          .maxDepth = *maker_.depth,
                          .maxSpecular = *maker_.specular,
                          .seed = seed_,
                          .stop = [&cancelled] { return cancelled.load(std::memory_order_relaxed); }};
    const StrategyTable table(kGridVertices);
    // A light, walls that scatter, the sensor; mirrors and glass come on top.
    const std::uint32_t matt = mostScatterings(problem) + 2;
    const bool longer = traitsOf(scene_->scene).specular || matt > kGridVertices;
    auto grid = std::make_shared<StrategyGrid>(StrategyGrid{.sensor = sensor_,
                                                            .film = StrategyFilm(table, pixelCount(sensor_)),
                                                            .longest = longer ? kGridVertices : matt,
                                                            .hasLonger = longer});
    grid->refusal = refusalOf(*findEstimator("bidirectional"), problem, maker_.params);
    if (grid->refusal.empty()) passes_.emplace(problem, maker_.params, table);
    grid->complete = !passes_;
    grid_ = std::move(grid);
}

bool StrategyWork::answers(const LightQuestion& question) const {
    const auto* profile = std::get_if<Profile>(&sensor_);
    return scene_ == question.scene && maker_ == makerFor(question) && seed_ == question.settings.seed &&
           effort_ == question.effort && (!profile || profile->segments.front() == question.at.segment);
}

bool StrategyWork::addBatch() {
    auto next = std::make_shared<StrategyGrid>(*grid_);
    Film& whole = next->film.whole;
    const auto least = static_cast<std::uint64_t>(kPathsPerBatch / pixelCount(sensor_));
    const std::uint64_t count =
        std::min(std::max({least, whole.passes / 2, std::uint64_t{1}}), kMostPasses - whole.passes);
    try {
        next->film.merge(passes_->render(whole.passes, count));
    } catch (const Stopped&) {
        return false;
    }
    const auto rays = static_cast<double>(whole.counts.rays);
    next->complete = rays >= effort_ * static_cast<double>(kMostRays) || whole.passes >= kMostPasses;
    tone(*next);
    grid_ = std::move(next);
    return true;
}

void recallStrategies(LightAnswer& answer, const std::unique_ptr<StrategyWork>& work) {
    if (answer.asked.pictures.has(View::strategies) && work && work->answers(answer.asked))
        answer.strategies = work->grid();
}

bool prepareStrategies(const LightQuestion& asked, std::unique_ptr<StrategyWork>& work,
                       const std::atomic<bool>& cancelled) {
    if (!asked.pictures.has(View::strategies)) return false;
    try {
        if (!work || !work->answers(asked)) work = std::make_unique<StrategyWork>(asked, cancelled);
    } catch (const Stopped&) {
        work.reset();
        return false;
    }
    return !work->grid()->complete;
}

}  // namespace halfdisk
