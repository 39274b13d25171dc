// What came out of a rendering, and what is told of it? The one list of facts behind files and summaries.
#pragma once

#include <string>
#include <vector>

#include "app/cli_output.h"
#include "app/render_sensor.h"

namespace halfdisk {

struct RenderResult {
    const RenderRequest& request;
    const SegmentIndex& index;
    const PictureOf& picture;
    Measurement measurement;
    double scale = 1.0;  ///< from light to a PNG's white
};

/// Mean of every pixel, in the unit of the sensor.
std::vector<Rgb> meansOf(const Film& film);

/// Whether a pixel's standard error is known: it takes two finite samples.
inline bool hasError(const Statistics& pixel) {
    return pixel.count > 1;
}

/// Bad samples of all pixels: contributions, and whole samples where an estimator adds them itself.
std::uint64_t nonFiniteOf(const Film& film);
std::uint64_t negativeOf(const Film& film);

/// The parameters by name: numbers, and names of choices.
Json paramsJson(const EstimatorInfo& info, const ParamValues& params);

/// Facts that CSV and JSON files start with, in their order. Only `seconds` differs from run to run.
Json resultFacts(const RenderResult& result);

/// A number as every file has it: the shortest text that keeps every bit, without negative zero.
std::string numberText(double value);

}  // namespace halfdisk
