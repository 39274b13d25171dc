#include "pixel_statistics.h"

#include <algorithm>
#include <cstring>

namespace halfdisk {
namespace {

// So many pixels are looked at, then added: the second time they come from the nearest cache.
constexpr std::size_t kBlock = 512;

// A row of pixels is a row of numbers, three a pixel.
static_assert(sizeof(Rgb) == 3 * sizeof(double));

// Whether all are finite and above zero, or zero. Looks at the bits: vectors of the oldest processors can
// compare numbers, but not count what they found.
bool areOrdinary(const double* values, std::size_t count) {
    constexpr std::uint64_t kSign = 0x8000000000000000, kOneMoreExponent = 0x0010000000000000;
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint64_t bits;
        std::memcpy(&bits, values + i, sizeof bits);
        // Of infinity and NaN the exponent is the highest, so that one more carries over into the sign.
        all |= bits | (bits + kOneMoreExponent);
    }
    return (all & kSign) == 0;
}

void addSample(double* __restrict mean, double* __restrict squares, const double* __restrict values,
               std::size_t numbers, double count) {
    for (std::size_t i = 0; i < numbers; ++i) {
        const double delta = values[i] - mean[i];
        const double after = mean[i] + delta / count;
        squares[i] += delta * (values[i] - after);
        mean[i] = after;
    }
}

void mergeInto(double* __restrict mean, double* __restrict squares, const double* __restrict laterMean,
               const double* __restrict laterSquares, std::size_t numbers, double here, double there) {
    const double share = there / (here + there), spread = here * there / (here + there);
    for (std::size_t i = 0; i < numbers; ++i) {
        const double delta = laterMean[i] - mean[i];
        mean[i] += delta * share;
        squares[i] += laterSquares[i] + delta * delta * spread;
    }
}

}  // namespace

void PixelStatistics::reset(std::size_t pixels) {
    samples = 0;
    mean.assign(pixels, Rgb(0.0));
    squares.assign(pixels, Rgb(0.0));
    odd.clear();
}

Statistics PixelStatistics::operator[](std::size_t pixel) const {
    const Odd bad = odd.empty() ? Odd{} : odd[pixel];
    return {samples - bad.nonFinite, bad.nonFinite, bad.negative, mean[pixel], squares[pixel]};
}

void PixelStatistics::set(std::size_t pixel, const Statistics& value) {
    mean[pixel] = value.mean;
    squares[pixel] = value.squares;
    odd[pixel] = {value.nonFinite, value.negative};
}

void PixelStatistics::addOdd(const Rgb* values, std::size_t first, std::size_t last) {
    odd.resize(size());
    for (std::size_t i = first; i < last; ++i) {
        Statistics pixel = (*this)[i];
        pixel.add(values[i]);
        set(i, pixel);
    }
}

void PixelStatistics::add(const std::vector<Rgb>& values) {
    if (empty()) reset(values.size());
    const double count = static_cast<double>(samples + 1);
    for (std::size_t first = 0; first < size(); first += kBlock) {
        const std::size_t last = std::min(first + kBlock, size()), numbers = 3 * (last - first);
        const double* block = &values[first].x;
        if (odd.empty() && areOrdinary(block, numbers)) {
            addSample(&mean[first].x, &squares[first].x, block, numbers, count);
        } else {
            addOdd(values.data(), first, last);
        }
    }
    ++samples;
}

void PixelStatistics::merge(const PixelStatistics& later) {
    if (empty()) reset(later.size());
    if (later.samples == 0) return;
    if (samples == 0) {
        *this = later;
        return;
    }
    if (odd.empty() && later.odd.empty()) {
        if (size() > 0)
            mergeInto(&mean[0].x, &squares[0].x, &later.mean[0].x, &later.squares[0].x, 3 * size(),
                      static_cast<double>(samples), static_cast<double>(later.samples));
    } else {
        odd.resize(size());
        for (std::size_t i = 0; i < size(); ++i) {
            Statistics pixel = (*this)[i];
            pixel.merge(later[i]);
            set(i, pixel);
        }
    }
    samples += later.samples;
}

}  // namespace halfdisk
