// What came out of a rendering, and what is told of it? The one list of facts behind files and summaries.
#include "app/render_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli.h"

namespace halfdisk {

std::vector<Rgb> meansOf(const Film& film) {
    return film.pixels.mean;
}

std::uint64_t nonFiniteOf(const Film& film) {
    std::uint64_t count = film.counts.nonFinite;
    for (const Statistics& pixel : film.pixels) count += pixel.nonFinite;
    return count;
}

std::uint64_t negativeOf(const Film& film) {
    std::uint64_t samples = 0;
    for (const Statistics& pixel : film.pixels) samples += pixel.negative;
    return std::max(film.counts.negative, samples);
}

Json paramsJson(const EstimatorInfo& info, const ParamValues& params) {
    Json object = Json::object();
    for (std::size_t i = 0; i < params.size(); ++i) {
        const ParamInfo& param = info.params[i];
        const std::string name(param.name);
        if (!param.choices.empty()) {
            object[name] = paramText(param, params[i]);
        } else if (param.whole) {
            object[name] = static_cast<std::int64_t>(params[i]);
        } else {
            object[name] = jsonOf(params[i]);
        }
    }
    return object;
}

Json resultFacts(const RenderResult& result) {
    const RenderRequest& request = result.request;
    const Film& film = result.measurement.film;
    const std::string sensor(nameOf(kPictureSensors, request.sensor));
    Json facts;
    facts["program"] = fmt::format("halfdisk {}", kVersion);
    facts["command"] = commandFor(request, film.passes, result.picture.width, result.picture.height);
    facts["scene"] = request.texts.scene;
    facts["sceneHash"] = request.sceneHash;
    facts["sensor"] = sensor;
    facts[sensor] = sensorFacts(result.picture, result.index);
    facts["unit"] = std::string(unitOf(request.sensor));
    facts["estimator"] = std::string(request.estimator->id);
    facts["parameters"] = paramsJson(*request.estimator, request.params);
    facts["samples"] = film.passes;
    facts["depth"] = request.maxDepth;
    facts["specular"] = request.maxSpecular;
    facts["seed"] = request.seed;
    facts["rays"] = film.counts.rays;
    facts["paths"] = film.counts.paths;
    facts["cut"] = film.counts.cut;
    facts["nonFinite"] = nonFiniteOf(film);
    facts["negative"] = negativeOf(film);
    facts["exposure"] = jsonOf(std::log2(result.scale));
    facts["seconds"] = jsonOf(result.measurement.seconds);
    return facts;
}

std::string numberText(double value) {
    return fmt::format("{}", value + 0.0);
}

}  // namespace halfdisk
