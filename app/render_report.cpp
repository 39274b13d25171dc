// How is a rendering told on the terminal, to people and to scripts?
#include "app/render_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

double channelMean(const Rgb& value) {
    return (value.x + value.y + value.z) / 3.0;
}

double raysPerSecond(const Measurement& measurement) {
    return measurement.seconds > 0.0 ? static_cast<double>(measurement.film.counts.rays) / measurement.seconds
                                     : 0.0;
}

std::string paramsLine(const RenderRequest& request) {
    std::string line;
    for (std::size_t i = 0; i < request.params.size(); ++i) {
        const ParamInfo& param = request.estimator->params[i];
        line += fmt::format("{}{} = {}", i == 0 ? "" : ", ", param.name, paramText(param, request.params[i]));
    }
    return line;
}

std::string errorLine(const PixelSummary& summary, std::size_t pixels) {
    if (summary.lit == 0) return fmt::format("no light reaches any of the {} pixels\n", pixels);
    const std::string lit = fmt::format("of {} pixels {} are lit", pixels, summary.lit);
    if (!summary.relativeErrorOfLit) return lit + "; their standard error takes two samples to be known\n";
    return fmt::format("{}; the median of their relative standard errors is {:.3g} %\n", lit,
                       100.0 * *summary.relativeErrorOfLit);
}

}  // namespace

PixelSummary summarize(const Film& film) {
    PixelSummary summary;
    std::vector<double> errors;
    for (const Statistics& pixel : film.pixels) {
        summary.mean += pixel.mean / static_cast<double>(film.pixels.size());
        const double mean = channelMean(pixel.mean);
        if (!(mean > 0.0)) continue;
        ++summary.lit;
        if (hasError(pixel)) errors.push_back(channelMean(pixel.standardError()) / mean);
    }
    if (errors.empty()) return summary;
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    summary.relativeErrorOfLit = *middle;
    return summary;
}

Json renderJson(const RenderResult& result) {
    const PixelSummary summary = summarize(result.measurement.film);
    Json object = resultFacts(result);
    object["threads"] = result.request.limits.threads;
    object["stopped"] = result.measurement.interrupted;
    object["mean"] = jsonOf(summary.mean);
    object["litPixels"] = summary.lit;
    object["relativeError"] = summary.relativeErrorOfLit ? jsonOf(*summary.relativeErrorOfLit) : Json();
    object["raysPerSecond"] = jsonOf(raysPerSecond(result.measurement));
    Json files = Json::array();
    for (const auto& path : result.request.outputs) files.push_back(path.string());
    object["files"] = files;
    return object;
}

std::string renderTable(const RenderResult& result) {
    const RenderRequest& request = result.request;
    const Film& film = result.measurement.film;
    const PixelSummary summary = summarize(film);
    std::string table =
        fmt::format("{}, {} sample{}, depth {}, specular {}, seed {}\n", request.estimator->id, film.passes,
                    film.passes == 1 ? "" : "s", request.maxDepth, request.maxSpecular, request.seed);
    if (!request.params.empty()) table += paramsLine(request) + "\n";
    table += sensorLine(result.picture, result.index) + "\n";
    table += fmt::format("\n{:<24} {:>12} {:>12} {:>12}\n", "", "red", "green", "blue");
    table += fmt::format("{:<14} {:<9} {:>12.6g} {:>12.6g} {:>12.6g}\n\n", "mean of pixels",
                         unitOf(request.sensor), summary.mean.x, summary.mean.y, summary.mean.z);
    table += errorLine(summary, film.pixels.size());
    table += fmt::format("{} rays in {:.3g} s on {} thread{} ({:.3g} Mrays/s)\n", film.counts.rays,
                         result.measurement.seconds, request.limits.threads,
                         request.limits.threads == 1 ? "" : "s", raysPerSecond(result.measurement) / 1e6);
    table += fmt::format("{} contributions not finite, {} negative, {} paths cut\n", nonFiniteOf(film),
                         negativeOf(film), film.counts.cut);
    table += fmt::format("exposure {:.4g} EV: light times {:.4g} is shown\n", std::log2(result.scale),
                         result.scale);
    for (const auto& path : request.outputs) table += fmt::format("written: {}\n", path.string());
    return table + countWarnings(film, request.maxSpecular);
}

std::string countWarnings(const Film& film, std::uint32_t maxSpecular) {
    std::string lines;
    if (const std::uint64_t bad = nonFiniteOf(film); bad > 0)
        lines += fmt::format(
            "\nWARNING: {} contributions were NaN or infinite and are left out: the result is not to be "
            "trusted\n",
            bad);
    if (const std::uint64_t bad = negativeOf(film); bad > 0)
        lines += fmt::format("\nWARNING: {} contributions were negative, which light cannot be\n", bad);
    if (film.counts.cut > 0)
        lines += fmt::format(
            "\nNOTE: {} of {} paths were given up after {} mirror and glass events in a row; the light that "
            "they would have brought is missing (--specular)\n",
            film.counts.cut, film.counts.paths, maxSpecular);
    return lines;
}

}  // namespace halfdisk
