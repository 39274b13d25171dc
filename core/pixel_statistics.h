// What do many samples of every pixel say? Means and variances of all pixels, in rows of numbers that the
// processor's vectors run through.
#pragma once

#include <iterator>
#include <vector>

#include "statistics.h"

namespace halfdisk {

/// As many Statistics as there are pixels, to which all pixels' samples are added together. Nearly always
/// every sample is finite, and their count is the same for all pixels.
struct PixelStatistics {
    /// A pixel's samples that were not finite or below zero: see Statistics.
    struct Odd {
        std::uint64_t nonFinite = 0, negative = 0;
    };

    std::uint64_t samples = 0;       ///< of each pixel, those that were not finite included
    std::vector<Rgb> mean, squares;  ///< of each pixel: see Statistics
    std::vector<Odd> odd;            ///< of each pixel; empty: none at all

    std::size_t size() const { return mean.size(); }
    bool empty() const { return mean.empty(); }
    /// To so many pixels without samples.
    void reset(std::size_t pixels);

    /// One sample of each pixel.
    void add(const std::vector<Rgb>& values);
    /// As if the samples of `later` had been added after these. Not commutative to the bit: merge in a fixed
    /// order.
    void merge(const PixelStatistics& later);

    Statistics operator[](std::size_t pixel) const;
    Statistics front() const { return (*this)[0]; }

    class Iterator {
     public:
        using iterator_category = std::input_iterator_tag;
        using value_type = Statistics;
        using difference_type = std::ptrdiff_t;
        using pointer = void;
        using reference = Statistics;

        Iterator(const PixelStatistics& pixels, std::size_t at) : pixels_(&pixels), at_(at) {}
        Statistics operator*() const { return (*pixels_)[at_]; }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        bool operator==(const Iterator& other) const { return at_ == other.at_; }

     private:
        const PixelStatistics* pixels_;
        std::size_t at_;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size()}; }

 private:
    void addOdd(const Rgb* values, std::size_t first, std::size_t last);
    void set(std::size_t pixel, const Statistics& value);
};

}  // namespace halfdisk
