// How does linear light become the bytes of a picture on a screen? A scale, and the sRGB curve.
#pragma once

#include <cstdint>
#include <vector>

#include "app/pfm_image.h"
#include "app/png_image.h"

namespace halfdisk {

/// Factor that brings the 99th percentile of the pixels' brightest channels to white; where most pixels are
/// black, the brightest one. 1 if all are.
double automaticScale(const std::vector<Rgb>& pixels);

/// 0 ... 1 linear to 0 ... 255, IEC 61966-2-1; clipped.
std::uint8_t srgbByte(double linear);

/// Opaque, every value times `scale`.
Image toned(const LinearImage& image, double scale);

}  // namespace halfdisk
