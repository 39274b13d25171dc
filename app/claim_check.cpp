#include "app/claim_check.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <limits>

#include "app/claim_picture.h"
#include "app/cli_probe_passes.h"
#include "app/light_answer.h"
#include "core/reference.h"
#include "core/stopwatch.h"
#include "lessons/claim_keys.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kDeepestReference = 8;

/// What a trial gives, whichever estimator made it.
struct Outcome {
    Rgb irradiance{0.0};
    std::optional<Rgb> standardError{}, radiance{}, direct{}, indirect{};
    double samples = 0.0;  ///< in all
    double rays = 0.0;     ///< of one repeat
    std::uint64_t nonFinite = 0;
};

ProbePlace placeOf(const SegmentIndex& index, const Trial& trial) {
    ProbePlace place;
    place.shaded = shadedPointOn(index, trial.at.segment, trial.at.t);
    place.at = place.shaded.P;
    place.radiance = isMatt(index, trial.at.segment);
    return place;
}

Outcome byCastRay(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place) {
    const ProbeAnswer answer = probe(index, question, place);
    const auto repeats = static_cast<double>(question.repeats);
    Outcome out{.irradiance = answer.irradiance.mean,
                .standardError = answer.irradiance.standardError,
                .direct = answer.estimate.direct,
                .indirect = answer.estimate.indirect,
                .samples = repeats * question.settings.samples,
                .rays = static_cast<double>(answer.estimate.rays) / repeats,
                .nonFinite = answer.estimate.nonFinite()};
    if (answer.radiance) out.radiance = answer.radiance->mean;
    return out;
}

Outcome byPasses(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place) {
    const PassesAnswer answer = probeByPasses(index, question, place);
    const Film& film = answer.measurement.film;
    if (answer.measurement.interrupted) throw std::runtime_error("interrupted");
    const auto passes = static_cast<double>(film.passes);
    Outcome out{.irradiance = answer.light.mean,
                .standardError = answer.light.standardError,
                .samples = passes,
                .rays = static_cast<double>(film.counts.rays) / passes,
                .nonFinite = film.counts.nonFinite};
    if (answer.radiance) out.radiance = answer.radiance->mean;
    return out;
}

Outcome outcomeOf(const SegmentIndex& index, const Trial& trial, unsigned threads) {
    ProbeQuestion question;
    question.estimator = findEstimator(trial.maker.estimator);
    question.settings = trial.settings;
    question.repeats = trial.repeats;
    question.threads = threads;
    const ProbePlace place = placeOf(index, trial);
    if (question.isCastRay()) return byCastRay(index, question, place);
    question.params = trial.maker.params;
    return byPasses(index, question, place);
}

Rgb exactOf(const SegmentIndex& index, const Trial& trial) {
    const ShadedPoint at = shadedPointOn(index, trial.at.segment, trial.at.t);
    Settings settings = trial.settings;
    settings.defects = {};  // which are what the exact value is to tell
    if (const auto exact = exactIrradiance(index.scene(), settings, at)) return *exact;
    const bool fewWalls = index.scene().segments.size() <= Reference::kMostWallsDeep;
    if (settings.maxDepth <= kDeepestReference && fewWalls && traitsOf(index.scene()).diffuseOnly)
        return Reference(index, settings.maxDepth).irradiance(at, settings.maxDepth);
    throw InputError(fmt::format(
        "the exact E is not known here: matt scenes of up to 60 walls have one up to depth 1, of up to "
        "{} up to depth {}",
        Reference::kMostWallsDeep, kDeepestReference));
}

double lostShare(const SegmentIndex& index, const DialSetting& dial) {
    const ExtremeCounts counts = measureDial(dial, index.scene());
    if (counts.rays == 0) throw InputError("no ray leaves a wall here");
    return static_cast<double>(counts.faults()) / static_cast<double>(counts.rays);
}

template <class Value>
const Value& given(const std::optional<Value>& value, std::string_view what) {
    if (!value) throw InputError(std::string(what));
    return *value;
}

/// A quantity that is not sampled at P.
double withoutRun(const ClaimPlace& place, Quantity quantity) {
    switch (quantity) {
        case Quantity::exact:
            return gray(exactOf(place.scene->index, place.trial));
        case Quantity::heaviest:
            return heaviestShare(place);
        case Quantity::noise:
            return pictureNoise(place);
        case Quantity::pictureError:
            return pictureError(place);
        case Quantity::raysTo:
            return raysToWished(place);
        case Quantity::planRays:
            return planRays(place);
        case Quantity::planBounces:
            return planBounces(place);
        case Quantity::lost:
            return lostShare(place.scene->index, place.trial.instruments.dial);
        default:
            break;
    }
    assert(false);
    return std::numeric_limits<double>::quiet_NaN();
}

double quantityOf(const std::shared_ptr<const PreparedScene>& scene, Quantity quantity, const Trial& trial,
                  unsigned threads) {
    if (!isSampledAtPoint(quantity)) return withoutRun({scene, trial}, quantity);
    const SegmentIndex& index = scene->index;
    const Outcome out = outcomeOf(index, trial, threads);
    const auto error = [&] {
        return gray(given(out.standardError,
                          "there is no standard error of one repeat, expected \"repeats\" of 2 or more"));
    };
    constexpr std::string_view kCastRayOnly = "only cast-ray tells direct from indirect light";
    switch (quantity) {
        case Quantity::irradiance:
            return gray(out.irradiance);
        case Quantity::direct:
            return gray(given(out.direct, kCastRayOnly));
        case Quantity::indirect:
            return gray(given(out.indirect, kCastRayOnly));
        case Quantity::radiance:
            return gray(given(out.radiance, "this wall is not matt, and has no one radiance"));
        case Quantity::error: {
            const double exact = gray(exactOf(index, trial));
            return std::abs(gray(out.irradiance) - exact) / std::abs(exact);
        }
        case Quantity::variance:
            return error() * error() * out.samples;
        case Quantity::spread:
            return error() * std::sqrt(out.samples);
        case Quantity::standardError:
            return error();
        case Quantity::relativeError:
            return error() * std::sqrt(out.samples / trial.settings.samples) / std::abs(gray(out.irradiance));
        case Quantity::rays:
            return out.rays;
        case Quantity::nonFinite:
            return static_cast<double>(out.nonFinite);
        default:
            break;
    }
    assert(false);
    return std::numeric_limits<double>::quiet_NaN();
}

bool holds(const Claim& claim, double value) {
    switch (claim.relation) {
        case Relation::atLeast:
            return value >= claim.number;
        case Relation::atMost:
            return value <= claim.number;
        case Relation::equals:
            return std::abs(value - claim.number) <= claim.tolerance;
    }
    return false;
}

}  // namespace

ClaimResult checkClaim(const std::string& file, const std::shared_ptr<const PreparedScene>& scene,
                       const Claim& claim, unsigned threads) {
    const Stopwatch watch;
    ClaimResult result;
    try {
        result.of = quantityOf(scene, claim.quantity, claim.of, threads);
        if (claim.over) result.over = quantityOf(scene, claim.quantity, *claim.over, threads);
        if (result.over == 0.0) throw InputError("it is divided by \"over\", which is 0");
    } catch (const InputError& error) {
        throw InputError(file, claim.where, fmt::format("the claim cannot be measured: {}", error.text));
    }
    result.value = result.over ? result.of / *result.over : result.of;
    result.holds = holds(claim, result.value);
    result.seconds = watch.seconds();
    return result;
}

std::string expectationOf(const Claim& claim) {
    switch (claim.relation) {
        case Relation::atLeast:
            return fmt::format("at least {}", claim.number);
        case Relation::atMost:
            return fmt::format("at most {}", claim.number);
        case Relation::equals:
            return claim.tolerance > 0.0 ? fmt::format("{} +- {}", claim.number, claim.tolerance)
                                         : fmt::format("{}", claim.number);
    }
    return {};
}

}  // namespace halfdisk
