#include "app/cli_probe_report.h"

#include <fmt/format.h>

#include <cmath>

#include "app/cli_arguments.h"

namespace halfdisk {
namespace {

Json defectsJson(DefectSet defects) {
    Json names = Json::array();
    for (const auto& defect : kDefects)
        if (defects.has(defect.value)) names.push_back(std::string(defect.name));
    return names;
}

/// (estimate - exact) / standard error to two decimals, NaN where an error of 0 leaves nothing to count in.
Rgb distanceInErrors(const Rgb& estimate, const Rgb& exact, const Rgb& standardError) {
    Rgb distance{0.0};
    for (int i = 0; i < 3; ++i) {
        // What rounding alone does is no distance.
        constexpr double kRounding = 1e-9;
        const double difference = estimate[i] - exact[i];
        if (std::abs(difference) <= kRounding * std::abs(exact[i])) continue;
        constexpr double kHundredths = 100.0;
        distance[i] = standardError[i] > 0.0
                          ? std::round(kHundredths * difference / standardError[i]) / kHundredths
                          : std::nan("");
    }
    return distance;
}

std::string warnings(const ProbeAnswer& answer) {
    const Statistics& samples = answer.estimate.samples;
    std::string lines;
    if (samples.nonFinite > 0)
        lines += fmt::format(
            "\nWARNING: {} of {} samples were NaN or infinite and are left out: the mean is not to be "
            "trusted\n",
            samples.nonFinite, samples.nonFinite + samples.count);
    if (samples.negative > 0 && answer.question.settings.defects == DefectSet{})
        lines +=
            fmt::format("\nWARNING: {} samples were negative, which light cannot be\n", samples.negative);
    return lines;
}

std::string heading(const ProbeAnswer& answer) {
    const ProbeQuestion& question = answer.question;
    const Settings& settings = question.settings;
    std::string lines =
        fmt::format("{}, {} samples x {} repeats, depth {}, sampler {}, emitters {}, seed {}\n",
                    question.estimator->id, settings.samples, question.repeats, settings.maxDepth,
                    nameOf(kSamplers, settings.sampler), nameOf(kEmitters, settings.emitters), settings.seed);
    if (settings.defects != DefectSet{}) {
        std::string names;
        for (const auto& defect : kDefects)
            if (settings.defects.has(defect.value))
                names += fmt::format("{}{}", names.empty() ? "" : ", ", defect.name);
        lines += fmt::format("as printed: {}\n", names);
    }
    const Vec2 at = answer.place.at + 0.0, N = answer.place.shaded.N + 0.0;
    lines +=
        fmt::format("at ({:.6g}, {:.6g}) m{}, normal ({:.6g}, {:.6g})\n", at.x, at.y,
                    answer.place.wall ? fmt::format(" on wall \"{}\"", *answer.place.wall) : "", N.x, N.y);
    return lines;
}

}  // namespace

Json jsonOrNull(const std::optional<Rgb>& value) {
    return value ? jsonOf(*value) : Json(nullptr);
}

std::string probeRow(std::string_view symbol, std::string_view meaning, std::string_view unit,
                     const Rgb& value) {
    const auto shown = [](double x) {
        return std::isnan(x) ? std::string("-") : fmt::format("{:.6g}", x + 0.0);
    };
    return fmt::format("{:<4} {:<26} {:<11} {:>12} {:>12} {:>12}\n", symbol, meaning, unit, shown(value.x),
                       shown(value.y), shown(value.z));
}

std::string probeRows(std::string_view symbol, std::string_view meaning, std::string_view unit,
                      const MeasuredRgb& measured) {
    std::string lines = probeRow(symbol, meaning, unit, measured.mean);
    if (measured.standardError) lines += probeRow("", "± standard error", unit, *measured.standardError);
    return lines;
}

std::string exactRows(const MeasuredRgb& measured, const std::optional<Rgb>& exact) {
    if (!exact) return {};
    std::string lines = probeRow("", "exact E", "W/m", *exact);
    if (measured.standardError)
        lines += probeRow("", "estimate - exact", "std. errors",
                          distanceInErrors(measured.mean, *exact, *measured.standardError));
    return lines;
}

Json measuredJson(const MeasuredRgb& measured) {
    Json object;
    object["mean"] = jsonOf(measured.mean);
    object["standardError"] = jsonOrNull(measured.standardError);
    return object;
}

Json probeJson(const ProbeAnswer& answer) {
    const ProbeQuestion& question = answer.question;
    const Settings& settings = question.settings;
    Json object;
    object["estimator"] = std::string(question.estimator->id);
    object["sampler"] = std::string(nameOf(kSamplers, settings.sampler));
    object["samples"] = settings.samples;
    object["depth"] = settings.maxDepth;
    object["seed"] = settings.seed;
    object["repeats"] = question.repeats;
    object["threads"] = question.threads;
    object["at"] = jsonOf(answer.place.at);
    object["normal"] = jsonOf(answer.place.shaded.N);
    object["irradiance"] = measuredJson(answer.irradiance);
    object["irradiance"]["direct"] = jsonOf(answer.estimate.direct);
    object["irradiance"]["indirect"] = jsonOf(answer.estimate.indirect);
    object["radiance"] = answer.radiance ? measuredJson(*answer.radiance) : Json(nullptr);
    object["variancePerSample"] = jsonOrNull(answer.variancePerSample);
    object["rays"] = answer.estimate.rays;
    object["seconds"] = jsonOf(answer.seconds);
    object["nonFinite"] = answer.estimate.nonFinite();
    object["emitters"] = std::string(nameOf(kEmitters, settings.emitters));
    if (settings.defects != DefectSet{}) object["asPrinted"] = defectsJson(settings.defects);
    for (const Rgb& value : answer.values) object["values"].push_back(jsonOf(value));
    return object;
}

std::string probeTable(const ProbeAnswer& answer) {
    const Estimate& estimate = answer.estimate;
    std::string table = heading(answer);
    table += fmt::format("\n{:<43} {:>12} {:>12} {:>12}\n", "", "red", "green", "blue");
    table += probeRows("E", "irradiance", "W/m", answer.irradiance);
    table += probeRow("", "direct: never scattered", "W/m", estimate.direct);
    table += probeRow("", "indirect: scattered", "W/m", estimate.indirect);
    table += exactRows(answer.irradiance, answer.exact);
    if (answer.radiance) table += probeRows("L", "radiance leaving the wall", "W/(m rad)", *answer.radiance);
    if (answer.variancePerSample)
        table += probeRow("", "variance of one sample", "(W/m)^2", *answer.variancePerSample);
    table += fmt::format("\n{} rays in {:.3g} s on {} thread{} ({:.3g} rays/s), {} samples not finite\n",
                         estimate.rays, answer.seconds, answer.question.threads,
                         answer.question.threads == 1 ? "" : "s",
                         answer.seconds > 0.0 ? static_cast<double>(estimate.rays) / answer.seconds : 0.0,
                         estimate.nonFinite());
    return table + warnings(answer);
}

}  // namespace halfdisk
