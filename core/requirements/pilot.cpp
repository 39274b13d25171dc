#include "core/requirements/pilot.h"

#include <algorithm>
#include <stdexcept>

#include "core/stopwatch.h"

namespace halfdisk {
namespace {

double sumOf(const Rgb& c) {
    return c.x + c.y + c.z;
}

}  // namespace

double Pilot::raysTo(double relativeError) const {
    if (variance == 0.0) return raysPerPass();
    return square > 0.0 ? raysPerPass() * std::max(1.0, variance / (square * relativeError * relativeError))
                        : kInfinity;
}

Sensor pilotSensor(const Sensor& sensor) {
    constexpr std::uint32_t kStrip = 48, kBins = 32, kSide = 20;
    Sensor small = sensor;
    if (auto* strip = std::get_if<EyeStrip>(&small)) strip->width = std::min(strip->width, kStrip);
    if (auto* profile = std::get_if<Profile>(&small)) profile->bins = std::min(profile->bins, kBins);
    if (auto* field = std::get_if<Field>(&small)) {
        field->width = std::min(field->width, kSide);
        field->height = std::min(field->height, kSide);
    }
    return small;
}

Pilot pilot(const Problem& problem, const Plan& plan, const PilotLimits& limits) {
    Problem asked{problem.index, problem.sensor, plan.maxDepth, plan.maxSpecular, problem.seed, problem.stop};
    const Stopwatch preparing;
    if (const std::string refusal = refusalOf(*plan.estimator, asked, plan.params); !refusal.empty())
        throw std::invalid_argument(refusal);
    const auto estimator = plan.estimator->make(asked, plan.params);
    Pilot result;
    result.preparation = preparing.seconds();
    result.pixels = pixelCount(problem.sensor);
    Film film;
    film.pixels.reset(result.pixels);
    Picture picture(result.pixels);
    const Stopwatch working;
    while (film.passes < limits.leastPasses ||
           std::max<std::uint64_t>(film.counts.rays, film.passes * result.pixels) < limits.rays) {
        std::fill(picture.begin(), picture.end(), Rgb(0.0));
        estimator->addPass(film.passes, picture, film.counts);
        film.add(picture);
        double total = 0.0;
        for (const Rgb& value : picture) total += sumOf(value);
        result.totals.push_back(total / (3.0 * static_cast<double>(result.pixels)));
    }
    result.seconds = working.seconds();
    result.passes = film.passes;
    result.rays = film.counts.rays;
    result.cut = film.counts.cut;
    result.paths = film.counts.paths;
    const double values = 3.0 * static_cast<double>(result.pixels);
    for (const Statistics& pixel : film.pixels) {
        result.mean += sumOf(pixel.mean) / values;
        // The mean's own noise is not light.
        result.square +=
            sumOf(pixel.mean * pixel.mean - pixel.variance() / static_cast<double>(film.passes)) / values;
        result.variance += sumOf(pixel.variance()) / values;
        result.picture.push_back(pixel.mean);
    }
    result.square = std::max(result.square, result.mean * result.mean);
    double squares = 0.0;
    const double n = static_cast<double>(result.passes);
    for (const double total : result.totals) squares += (total - result.mean) * (total - result.mean);
    result.meanError = n > 1.0 ? std::sqrt(squares / (n - 1.0) / n) : 0.0;
    return result;
}

}  // namespace halfdisk
