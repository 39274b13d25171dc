#include "strategies.h"

#include <numeric>

namespace halfdisk {
namespace {

/// The mean of each of as many equal parts as `means` has.
void meanOfParts(const Picture& pictures, Picture& means) {
    const std::size_t pixels = pictures.size() / means.size();
    for (std::size_t part = 0; part < means.size(); ++part) {
        const auto from = pictures.begin() + static_cast<std::ptrdiff_t>(part * pixels);
        means[part] = std::accumulate(from, from + static_cast<std::ptrdiff_t>(pixels), Rgb(0.0)) /
                      static_cast<double>(pixels);
    }
}

}  // namespace

StrategyFilm::StrategyFilm(StrategyTable strategies, std::size_t pixels) : table(strategies) {
    const std::size_t parts = table.size() + 1;
    whole.pixels.reset(pixels);
    weighted.reset(parts * pixels);
    alone.reset(parts * pixels);
    weightedMeans.reset(parts);
    aloneMeans.reset(parts);
    wholeMean.reset(1);
}

void StrategyFilm::add(const Picture& picture, const StrategyPictures& pictures) {
    whole.add(picture);
    weighted.add(pictures.weighted);
    alone.add(pictures.alone);
    Picture means(table.size() + 1), mean(1);
    meanOfParts(pictures.weighted, means);
    weightedMeans.add(means);
    meanOfParts(pictures.alone, means);
    aloneMeans.add(means);
    meanOfParts(picture, mean);
    wholeMean.add(mean);
}

void StrategyFilm::merge(const StrategyFilm& later) {
    whole.merge(later.whole);
    weighted.merge(later.weighted);
    alone.merge(later.alone);
    weightedMeans.merge(later.weightedMeans);
    aloneMeans.merge(later.aloneMeans);
    wholeMean.merge(later.wholeMean);
}

PixelStatistics StrategyFilm::pictureOf(const PixelStatistics& all, std::size_t place) const {
    const auto cut = [&](const auto& values) {
        const auto from = values.begin() + static_cast<std::ptrdiff_t>(place * pixels());
        return std::decay_t<decltype(values)>(from, from + static_cast<std::ptrdiff_t>(pixels()));
    };
    PixelStatistics part;
    part.samples = all.samples;
    part.mean = cut(all.mean);
    part.squares = cut(all.squares);
    if (!all.odd.empty()) part.odd = cut(all.odd);
    return part;
}

}  // namespace halfdisk
