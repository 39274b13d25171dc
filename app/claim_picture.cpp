#include "app/claim_picture.h"

#include <fmt/format.h>

#include <atomic>
#include <stdexcept>

#include "app/exact_stages.h"
#include "app/instrument_stages.h"
#include "app/light_stages.h"
#include "app/picture_stages.h"
#include "core/requirements/requirements.h"
#include "core/trade/trade_report.h"

namespace halfdisk {
namespace {

// Of a trade's cell, of its reference where there is no exact one, and of a plan: some seconds.
constexpr double kCellRays = 2'000'000.0, kReferenceRays = 20'000'000.0;
constexpr std::uint64_t kPlanRays = 1'000'000;

View viewOf(const ClaimPlace& place) {
    switch (place.trial.picture) {
        case ClaimPicture::eye:
            return View::eye;
        case ClaimPicture::field:
            return View::field;
        case ClaimPicture::profile:
            return View::profile;
        case ClaimPicture::seen:
            break;
    }
    return place.scene->scene.eye ? View::eye : View::profile;
}

/// The run that is recorded of the trial's estimator.
Run runOf(const Trial& trial) {
    for (const auto& run : kRuns)
        if (run.name == trial.maker.estimator && run.value != Run::castRay) return run.value;
    throw InputError(
        fmt::format("{} follows no paths from a pixel, expected an estimator that does, such as path",
                    trial.maker.estimator));
}

/// What makes its picture, which follows as many mirrors and skins of glass as the trial does.
Maker pictureMaker(const Trial& trial) {
    Maker maker = trial.maker;
    maker.specular = trial.settings.maxSpecular;
    return maker;
}

LightQuestion questionOf(const ClaimPlace& place) {
    LightQuestion asked;
    asked.scene = place.scene;
    asked.at = place.trial.at;
    asked.settings = place.trial.settings;
    asked.instrumentSettings = place.trial.instruments;
    return asked;
}

/// The question's only picture, finished, by the trial's estimator.
LightAnswer finishedPicture(const ClaimPlace& place, View view) {
    LightAnswer answer;
    answer.asked = questionOf(place);
    answer.asked.pictures.set(view, true);
    answer.asked.pictures.set(View::difference, true);
    answer.asked.makers.first = pictureMaker(place.trial);
    if (!sensorOf(view, answer.asked)) throw InputError("the scene has no eye");
    PictureCache cache;
    const std::atomic<bool> cancelled{false};
    while (!answer.pictures.of(view) || !answer.pictures.of(view)->complete)
        refinePictures(
            answer, cache, cancelled, [] {}, 1);
    if (const std::string& refusal = answer.pictures.of(view)->refusal; !refusal.empty())
        throw InputError(refusal);
    return answer;
}

Problem problemOf(const ClaimPlace& place, const Sensor& sensor) {
    return {.index = place.scene->index,
            .sensor = sensor,
            .maxDepth = place.trial.settings.maxDepth,
            .maxSpecular = place.trial.settings.maxSpecular,
            .seed = place.trial.settings.seed};
}

RequirementsAnswer requirementsAt(const ClaimPlace& place, const Sensor& sensor) {
    RequirementsQuestion question{place.scene->index, sensor, place.trial.instruments.tolerance,
                                  place.trial.instruments.forced, place.trial.settings.seed};
    try {
        return requirementsOf(question);
    } catch (const std::invalid_argument& refusal) {
        throw InputError(refusal.what());
    }
}

}  // namespace

double pictureNoise(const ClaimPlace& place) {
    const View view = viewOf(place);
    const LightAnswer answer = finishedPicture(place, view);
    if (const auto& noise = answer.pictures.of(view)->noise) return *noise;
    throw InputError("the picture is black, or made by a single pass: it has no noise to measure");
}

double pictureError(const ClaimPlace& place) {
    const View view = viewOf(place);
    LightAnswer answer = finishedPicture(place, view);
    if (view == View::field) answer.asked.makers.second = answer.asked.makers.first;  // else none is wanted
    ReferenceCache references;
    findExactPictures(answer, references, std::atomic<bool>{false});
    if (const auto error = errorOf(answer, view, 0)) return *error;
    throw InputError(
        "the exact picture is not known here: scenes with few, matt walls have one, up to depth 8");
}

double raysToWished(const ClaimPlace& place) {
    const Sensor sensor = instrumentSensor(questionOf(place));
    const Problem problem = problemOf(place, sensor);
    const double wished = place.trial.instruments.wishedError;
    const Maker& maker = place.trial.maker;
    try {
        std::optional<TradeReference> reference = exactReference(problem);
        if (!reference) reference = longRun(problem, {.rays = kReferenceRays});
        const TradeSetting setting{findEstimator(maker.estimator), maker.params, problem.maxDepth};
        TradeCell cell = measureCell(problem, setting, problem.maxDepth, *reference, {.rays = kCellRays});
        if (!cell.measured()) throw InputError(cell.refusal);
        const TradeTruth truth{reference->light(), reference->relativeError, reference->exact(),
                               problem.maxDepth};
        const TradeReport report = tradeReport({std::move(cell)}, truth, wished);
        const std::optional<double> rays = report.verdicts.front().toTarget[at(TradeCost::rays)];
        if (!rays) throw InputError(fmt::format("it never comes to an error of {}", wished));
        return *rays;
    } catch (const NoReference& why) {
        throw InputError(why.what());
    }
}

double heaviestShare(const ClaimPlace& place) {
    if (!place.trial.pixel) throw InputError("no pixel is named, expected \"pixel\", from 0 to 255");
    const Run run = runOf(place.trial);
    if (!place.scene->scene.eye) throw InputError("the scene has no eye");
    LightAnswer answer;
    answer.asked = questionOf(place);
    answer.asked.pixel = place.trial.pixel;
    answer.asked.makers.first = pictureMaker(place.trial);
    answer.asked.run = run;
    answer.point = shadedPointOn(place.scene->index, place.trial.at.segment, place.trial.at.t);
    recordPathRun(answer, std::atomic<bool>{false});
    if (!answer.pathRun->refusal.empty()) throw InputError(answer.pathRun->refusal);
    double most = 0.0, all = 0.0;
    for (const SampleRow& row : *answer.rows) {
        most = std::max(most, gray(row.adds));
        all += gray(row.adds);
    }
    if (!(all > 0.0)) throw InputError("the pixel is black: no path brings more than another");
    return most / all;
}

double planRays(const ClaimPlace& place) {
    const Sensor sensor = pilotSensor(instrumentSensor(questionOf(place)));
    const RequirementsAnswer answer = requirementsAt(place, sensor);
    const Pilot run = pilot(problemOf(place, sensor), answer.plan, {.rays = kPlanRays});
    return run.raysTo(answer.tolerance);
}

double planBounces(const ClaimPlace& place) {
    return requirementsAt(place, instrumentSensor(questionOf(place))).plan.maxDepth;
}

}  // namespace halfdisk
