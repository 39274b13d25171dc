// What does an estimator of the registry answer to a probe? Passes at one point, or along one ray.
#include "app/cli_probe_passes.h"

#include <fmt/format.h>

#include "app/cli_probe_report.h"
#include "app/estimator_arguments.h"
#include "app/render_report.h"

namespace halfdisk {
namespace {

Sensor sensorOf(const ProbeQuestion& question, const ProbePlace& place) {
    if (question.look) return Look{place.shaded.P, *question.look};
    return Probe{place.shaded};
}

MeasuredRgb measured(const Statistics& pixel) {
    MeasuredRgb value{pixel.mean, std::nullopt};
    if (hasError(pixel)) value.standardError = pixel.standardError();
    return value;
}

MeasuredRgb leaving(const SegmentIndex& index, const ShadedPoint& at, const MeasuredRgb& irradiance) {
    MeasuredRgb radiance{outgoingRadiance(index, at, irradiance.mean), std::nullopt};
    if (irradiance.standardError) radiance.standardError = *irradiance.standardError * at.albedo / 2.0;
    return radiance;
}

}  // namespace

PassesAnswer probeByPasses(const SegmentIndex& index, const ProbeQuestion& question,
                           const ProbePlace& place) {
    if (question.isCastRay()) refuseTooManyRays(index, question);
    const Sensor sensor = sensorOf(question, place);
    const Settings& settings = question.settings;
    const Problem problem{index, sensor, settings.maxDepth, settings.maxSpecular, settings.seed};
    PassesAnswer answer{question, place, {}, {}, {}, {}, {}};
    answer.measurement = measure(*question.estimator, problem, question.params,
                                 {question.passes(), std::nullopt, question.threads}, {},
                                 question.list ? &answer.values : nullptr);
    if (answer.measurement.film.passes == 0) return answer;
    answer.light = measured(answer.measurement.film.pixels.front());
    if (place.radiance) answer.radiance = leaving(index, place.shaded, answer.light);
    return answer;
}

Json passesJson(const PassesAnswer& answer) {
    const ProbeQuestion& question = answer.question;
    const Film& film = answer.measurement.film;
    const Statistics& pixel = film.pixels.front();
    Json object;
    object["estimator"] = std::string(question.estimator->id);
    object["parameters"] = paramsJson(*question.estimator, question.params);
    object["samples"] = question.isCastRay() ? question.settings.samples : film.passes;
    object["depth"] = question.settings.maxDepth;
    object["specular"] = question.settings.maxSpecular;
    object["seed"] = question.settings.seed;
    if (question.isCastRay()) object["repeats"] = film.passes;
    object["threads"] = question.threads;
    object["at"] = jsonOf(answer.place.at);
    object[question.look ? "look" : "normal"] = jsonOf(answer.place.shaded.N);
    object["irradiance"] = question.look ? Json(nullptr) : measuredJson(answer.light);
    object["radiance"] = nullptr;
    if (question.look) object["radiance"] = measuredJson(answer.light);
    if (answer.radiance) object["radiance"] = measuredJson(*answer.radiance);
    object["variancePerSample"] = hasError(pixel) ? jsonOf(pixel.variance()) : Json(nullptr);
    object["rays"] = film.counts.rays;
    object["paths"] = film.counts.paths;
    object["cut"] = film.counts.cut;
    object["seconds"] = jsonOf(answer.measurement.seconds);
    object["nonFinite"] = nonFiniteOf(film);
    object["negative"] = negativeOf(film);
    object["stopped"] = answer.measurement.interrupted;
    for (const Rgb& value : answer.values) object["values"].push_back(jsonOf(value));
    return object;
}

std::string passesTable(const PassesAnswer& answer) {
    const ProbeQuestion& question = answer.question;
    const Film& film = answer.measurement.film;
    std::string table =
        fmt::format("{}, {} samples, depth {}, specular {}, seed {}\n", question.estimator->id, film.passes,
                    question.settings.maxDepth, question.settings.maxSpecular, question.settings.seed);
    const Vec2 at = answer.place.at + 0.0, N = answer.place.shaded.N + 0.0;
    table += fmt::format("at ({:.6g}, {:.6g}) m{}, {} ({:.6g}, {:.6g})\n", at.x, at.y,
                         answer.place.wall ? fmt::format(" on wall \"{}\"", *answer.place.wall) : "",
                         question.look ? "looking along" : "normal", N.x, N.y);
    table += fmt::format("\n{:<43} {:>12} {:>12} {:>12}\n", "", "red", "green", "blue");
    if (question.look) {
        table += probeRows("L", "radiance that arrives", "W/(m rad)", answer.light);
    } else {
        table += probeRows("E", "irradiance", "W/m", answer.light);
        table += exactRows(answer.light, answer.exact);
    }
    if (answer.radiance) table += probeRows("L", "radiance leaving the wall", "W/(m rad)", *answer.radiance);
    table += fmt::format("\n{} rays in {:.3g} s on {} thread{}, {} contributions not finite\n",
                         film.counts.rays, answer.measurement.seconds, question.threads,
                         question.threads == 1 ? "" : "s", nonFiniteOf(film));
    return table + countWarnings(film, question.settings.maxSpecular);
}

}  // namespace halfdisk
