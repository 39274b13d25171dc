#include "app/cli_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/cli_arguments.h"
#include "core/nearest_wall.h"
#include "lessons/wall_point.h"

namespace halfdisk {
namespace {

constexpr std::string_view kPlaceForm = "X,Y or NAME:T";

unsigned threadsOfMachine() {
    return std::clamp(std::thread::hardware_concurrency(), 1u, static_cast<unsigned>(kThreadsInfo.most));
}

[[noreturn]] void failNoWall(const Scene& scene, const std::string& at, Vec2 P) {
    const NearestWall nearest = nearestWall(scene, P);
    const std::string where = nearest.segment == kNoSegment
                                  ? "the scene has no walls"
                                  : fmt::format("the nearest, \"{}\", is {:.3g} m away",
                                                scene.segmentNames[nearest.segment], nearest.distance);
    failArgument("--at", at,
                 fmt::format("is on no wall ({}), expected a point on a wall, or --normal X,Y too", where));
}

/// Where the named or numbered point is, on its wall if it is on one.
Vec2 positionAsked(const SegmentIndex& index, const std::string& at) {
    if (at.find(':') == std::string::npos) return pointArgument("--at", at, kPlaceForm);
    try {
        const WallPoint point = parseWallPoint(at, index.scene());
        return index.pointOn(point.segment, point.t);
    } catch (const InputError& error) {
        throw InputError(fmt::format("--at: {}", error.text));
    }
}

/// The front of the wall at P, if a wall is there. A named wall is that wall, also where others touch it.
std::optional<ShadedPoint> frontAsked(const SegmentIndex& index, const std::string& at, Vec2 P) {
    if (at.find(':') == std::string::npos) return shadedPointAt(index, P, std::nullopt);
    const WallPoint point = parseWallPoint(at, index.scene());
    return shadedPointOn(index, point.segment, point.t);
}

void refuseTooManyRays(const SegmentIndex& index, const ProbeQuestion& question) {
    const double rays = raysPerRepeat(index, question.settings) * static_cast<double>(question.repeats);
    if (question.anyway || rays <= kMostProbeRays) return;
    const std::string count = std::isfinite(rays) ? fmt::format("{:.3g}", rays) : "more than 1e300";
    throw InputError(
        fmt::format("this would cast up to {} rays, more than 10^10: lower --samples, --depth or --repeat, "
                    "or add --anyway",
                    count));
}

MeasuredRgb radianceOf(const SegmentIndex& index, const ShadedPoint& at, const MeasuredRgb& irradiance,
                       DefectSet defects) {
    MeasuredRgb radiance{outgoingRadiance(index, at, irradiance.mean, defects), std::nullopt};
    const double norm = defects.has(Defect::albedo) ? kPi : 2.0;
    if (irradiance.standardError) radiance.standardError = *irradiance.standardError * at.albedo / norm;
    return radiance;
}

}  // namespace

ProbeQuestion probeQuestion(const ProbeTexts& texts) {
    ProbeQuestion question;
    question.estimator = namedArgument("--estimator", texts.estimator, kEstimators);
    Settings& settings = question.settings;
    settings.samples =
        static_cast<std::uint32_t>(wholeArgument("--samples", texts.samples, kProbeSamplesInfo));
    settings.maxDepth = static_cast<std::uint32_t>(wholeArgument("--depth", texts.depth, kMaxDepthInfo));
    settings.sampler = namedArgument("--sampler", texts.sampler, kSamplers);
    settings.emitters = namedArgument("--emitters", texts.emitters, kEmitters);
    if (texts.asPrinted == "true") {
        settings.defects = DefectSet::all();
    } else if (!texts.asPrinted.empty()) {
        settings.defects = defectsArgument("--as-printed", texts.asPrinted);
    }
    settings.seed = wholeArgument("--seed", texts.seed, kSeedInfo);
    question.repeats = wholeArgument("--repeat", texts.repeats, kRepeatsInfo);
    question.threads = texts.threads
                           ? static_cast<unsigned>(wholeArgument("--threads", *texts.threads, kThreadsInfo))
                           : threadsOfMachine();
    if (texts.normal) question.normal = directionArgument("--normal", *texts.normal);
    question.anyway = texts.anyway;
    return question;
}

ProbePlace probePlace(const SegmentIndex& index, const std::string& at, std::optional<Vec2> normal) {
    const Vec2 P = positionAsked(index, at);
    const std::optional<ShadedPoint> front = frontAsked(index, at, P);
    if (!front && !normal) failNoWall(index.scene(), at, P);

    ProbePlace place;
    place.shaded = normal ? *shadedPointAt(index, P, normal) : *front;
    place.at = front ? front->P : P;
    if (front) place.wall = index.scene().segmentNames[front->segment];
    place.radiance = !normal;
    return place;
}

ProbeAnswer probe(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place) {
    refuseTooManyRays(index, question);
    ProbeAnswer answer;
    answer.question = question;
    answer.place = place;
    const auto start = std::chrono::steady_clock::now();
    answer.estimate = estimateIrradiance(index, place.shaded, question.settings,
                                         {.repeats = question.repeats, .threads = question.threads});
    answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const Estimate& estimate = answer.estimate;
    answer.irradiance.mean = estimate.irradiance();
    if (estimate.repeats.count > 1) answer.irradiance.standardError = estimate.repeats.standardError();
    if (place.radiance)
        answer.radiance = radianceOf(index, place.shaded, answer.irradiance, question.settings.defects);
    if (question.settings.sampler != Sampler::stratified && estimate.samples.count > 1)
        answer.variancePerSample = estimate.samples.variance();
    return answer;
}

}  // namespace halfdisk
