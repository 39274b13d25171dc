#include "core/estimators/strategy_passes.h"

#include <algorithm>

namespace halfdisk {

StrategyPasses::StrategyPasses(const Problem& problem, ParamValues params, StrategyTable table)
    : setup_(joinSetupOf(problem, params)), table_(table) {
    setup_.onlyS = setup_.onlyT = -1;
    setup_.weighs = true;
}

StrategyFilm StrategyPasses::render(std::uint64_t firstPass, std::uint64_t passes) const {
    const std::size_t pixels = pixelCount(setup_.problem.sensor);
    StrategyFilm film(table_, pixels);
    StrategyPictures pictures(table_, pixels);
    Picture picture(pixels);
    for (std::uint64_t pass = firstPass; pass < firstPass + passes; ++pass) {
        std::fill(picture.begin(), picture.end(), Rgb(0.0));
        pictures.clear();
        joinPaths(setup_, pass, picture, film.whole.counts, &pictures);
        film.add(picture, pictures);
    }
    return film;
}

}  // namespace halfdisk
