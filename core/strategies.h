// What does each strategy (s, t) of paths from both ends bring? Their pictures kept apart, of one pass and of
// many: each with its weight, as it stands in the sum, and alone, as if there were no other.
#pragma once

#include "film.h"

namespace halfdisk {

/// s vertices from the light, t from the sensor, which is the last of them; 2 or more together.
struct Strategy {
    std::uint32_t s = 0, t = 0;
    std::uint32_t vertices() const { return s + t; }
    bool operator==(const Strategy&) const = default;
};

/// Those of paths of up to so many vertices, by length and then by s; after them all longer ones together.
class StrategyTable {
 public:
    explicit StrategyTable(std::uint32_t mostVertices) : most_(mostVertices) {}

    std::uint32_t mostVertices() const { return most_; }
    std::size_t size() const { return first(most_ + 1); }
    std::size_t longer() const { return size(); }  ///< place of all longer ones
    std::size_t placeOf(Strategy strategy) const {
        const std::uint32_t n = strategy.vertices();
        return n > most_ ? longer() : first(n) + strategy.s;
    }
    Strategy operator[](std::size_t place) const {
        std::uint32_t n = kLeast;
        while (first(n + 1) <= place) ++n;
        const auto s = static_cast<std::uint32_t>(place - first(n));
        return {s, n - s};
    }
    bool operator==(const StrategyTable&) const = default;

 private:
    static constexpr std::uint32_t kLeast = 2;
    // Paths of n vertices have n + 1 strategies.
    static constexpr std::size_t first(std::size_t n) { return n * (n + 1) / 2 - 3; }

    std::uint32_t most_;
};

/// Of one pass: for each strategy of the table, and for the longer ones, as many pixels as the sensor has.
struct StrategyPictures {
    StrategyTable table;
    std::size_t pixels;
    Picture weighted, alone;

    StrategyPictures(StrategyTable strategies, std::size_t pixelsEach)
        : table(strategies),
          pixels(pixelsEach),
          weighted((strategies.size() + 1) * pixelsEach),
          alone(weighted.size()) {}

    void clear() {
        std::fill(weighted.begin(), weighted.end(), Rgb(0.0));
        std::fill(alone.begin(), alone.end(), Rgb(0.0));
    }
    /// What one path brings. As in addTo, what is not finite stays out.
    void add(Strategy strategy, std::uint32_t pixel, const Rgb& value, double weight) {
        const std::size_t at = table.placeOf(strategy) * pixels + pixel;
        if (isFinite(value * weight)) weighted[at] += value * weight;
        if (isFinite(value)) alone[at] += value;
    }
};

/// Of many passes. `whole` is the picture that the estimator itself makes of them, to the bit: the sum of all
/// strategies with their weights.
struct StrategyFilm {
    StrategyTable table;
    Film whole;
    PixelStatistics weighted, alone;  ///< of every pixel of one strategy after the other
    PixelStatistics weightedMeans, aloneMeans,
        wholeMean;  ///< of strategies' and the whole's mean over all pixels

    StrategyFilm(StrategyTable strategies, std::size_t pixels);

    std::size_t pixels() const { return whole.pixels.size(); }
    void add(const Picture& picture, const StrategyPictures& pictures);
    void merge(const StrategyFilm& later);

    /// One strategy's picture (or, at table.longer(), that of all longer ones).
    PixelStatistics pictureOf(const PixelStatistics& all, std::size_t place) const;
};

}  // namespace halfdisk
