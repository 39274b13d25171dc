// Where is a probe, and what does castRay answer there?
#include "app/cli_probe.h"

#include <fmt/format.h>

#include <cmath>

#include "app/cli_arguments.h"
#include "core/nearest_wall.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "lessons/wall_point.h"

namespace halfdisk {
namespace {

constexpr std::string_view kPlaceForm = "X,Y or NAME:T";

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

/// Each repeat once more by itself: their sum is not kept apart.
std::vector<Rgb> valuesOfRepeats(const SegmentIndex& index, const ProbeQuestion& question,
                                 const ShadedPoint& at) {
    std::vector<Rgb> values(question.repeats);
    const auto repeat = [&](std::uint64_t r) {
        const EstimateOptions one{.firstRepeat = r, .repeats = 1};
        return estimateIrradiance(index, at, question.settings, one).irradiance();
    };
    std::uint64_t next = 0;
    forChunksInOrder(question.repeats, question.threads, nullptr, repeat,
                     [&](const Rgb& value) { values[next++] = value; });
    return values;
}

MeasuredRgb radianceOf(const SegmentIndex& index, const ShadedPoint& at, const MeasuredRgb& irradiance,
                       DefectSet defects) {
    MeasuredRgb radiance{outgoingRadiance(index, at, irradiance.mean, defects), std::nullopt};
    const double norm = defects.has(Defect::albedo) ? kPi : 2.0;
    if (irradiance.standardError) radiance.standardError = *irradiance.standardError * at.albedo / norm;
    return radiance;
}

}  // namespace

bool isMatt(const SegmentIndex& index, std::uint32_t segment) {
    return std::holds_alternative<Diffuse>(index.material(segment)) &&
           !isSmooth(index.scene().segments[segment]);
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

ProbePlace probePlace(const SegmentIndex& index, const std::string& at, std::optional<Vec2> normal) {
    const Vec2 P = positionAsked(index, at);
    const std::optional<ShadedPoint> front = frontAsked(index, at, P);
    if (!front && !normal) failNoWall(index.scene(), at, P);

    ProbePlace place;
    place.shaded = normal ? *shadedPointAt(index, P, normal) : *front;
    place.at = front ? front->P : P;
    if (front) place.wall = index.scene().segmentNames[front->segment];
    place.radiance = !normal && isMatt(index, place.shaded.segment);
    return place;
}

ProbePlace lookPlace(const SegmentIndex& index, const std::string& at, Vec2 direction) {
    ProbePlace place;
    place.at = positionAsked(index, at);
    place.shaded = {place.at, direction};
    if (const std::optional<ShadedPoint> front = frontAsked(index, at, place.at)) {
        place.at = front->P;
        place.wall = index.scene().segmentNames[front->segment];
        place.shaded.P = originOff(index, front->segment, front->P, direction);
    }
    return place;
}

ProbeAnswer probe(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place) {
    refuseTooManyRays(index, question);
    ProbeAnswer answer;
    answer.question = question;
    answer.place = place;
    const Stopwatch watch;
    answer.estimate = estimateIrradiance(index, place.shaded, question.settings,
                                         {.repeats = question.repeats, .threads = question.threads});
    answer.seconds = watch.seconds();

    const Estimate& estimate = answer.estimate;
    answer.irradiance.mean = estimate.irradiance();
    if (estimate.repeats.count > 1) answer.irradiance.standardError = estimate.repeats.standardError();
    if (place.radiance)
        answer.radiance = radianceOf(index, place.shaded, answer.irradiance, question.settings.defects);
    if (question.list) answer.values = valuesOfRepeats(index, question, place.shaded);
    if (question.settings.sampler != Sampler::stratified && estimate.samples.count > 1)
        answer.variancePerSample = estimate.samples.variance();
    return answer;
}

}  // namespace halfdisk
