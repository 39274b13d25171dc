// What does one sample of the run say, and what are all of a pixel's together? The words of the list.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

/// "path 3", "n = 2: -20\u00b0, ceiling".
std::string sampleName(const LightAnswer& answer, const SampleRow& row);

/// Of a pixel what this path alone says of it, W/(m rad), where the paths' mean is the pixel's value; else
/// what the sample adds to the estimate.
Rgb sampleValue(const LightAnswer& answer, const SampleRow& row);
/// As it stands in the list; of a pixel's coloured light the mean of red, green and blue.
/// `most` is what the brightest row adds: what rounding leaves beside it is "\u2248 0".
std::string sampleNumber(const LightAnswer& answer, const SampleRow& row, double most);

/// In full, for a reader who wants to know.
std::string sampleMeaning(const LightAnswer& answer, const SampleRow& row);

/// Whether the run's event belongs to this row.
bool isOfRow(const LightAnswer& answer, const SampleRow& row, std::size_t event);

// Of a pixel's run:
/// Where two estimators are compared: which of them the pixel is of, or whose run is shown instead. Else
/// empty.
std::string whosePixel(const LightAnswer& answer);
/// How the paths' sum makes the pixel's value, and in few words.
std::string pixelSumWords(const LightAnswer& answer);
std::string shortPixelSumWords(const LightAnswer& answer, bool unit);
/// Which pixel, by which estimator, and which path brings most.
std::string pixelSumMeaning(const LightAnswer& answer);

}  // namespace halfdisk
