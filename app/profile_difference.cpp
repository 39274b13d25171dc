#include "app/profile_difference.h"

#include <algorithm>
#include <cmath>

#include "app/light_progress.h"

namespace halfdisk {

std::array<ProfileDifference, 2> profileDifferences(const AppState& state) {
    std::array<ProfileDifference, 2> found;
    if (!state.answer) return found;
    for (std::size_t side = 0; side < 2; ++side) {
        const auto& picture = (side == 0 ? state.answer->pictures : state.answer->against).profile;
        const auto& exact = state.answer->exactPictures[side].profile;
        if (!picture || !exact || picture->film.passes == 0) continue;
        const PixelStatistics& bins = picture->film.pixels;
        if (bins.size() != exact->size()) continue;
        double mean = 0.0;
        for (const Rgb& bin : *exact) mean += gray(bin) / static_cast<double>(exact->size());
        if (!(mean > 0.0)) continue;
        for (std::size_t i = 0; i < exact->size(); ++i) {
            const Statistics bin = bins[i];
            const double error = gray(bin.standardError());
            found[side].percent.push_back(100.0 * (gray(bin.mean) - gray((*exact)[i])) / mean);
            found[side].error.push_back(std::isfinite(error) ? 100.0 * error / mean : 0.0);
        }
    }
    return found;
}

double reachOf(const std::array<ProfileDifference, 2>& differences) {
    std::vector<double> sizes;
    for (const ProfileDifference& one : differences)
        for (const double percent : one.percent)
            if (std::isfinite(percent)) sizes.push_back(std::abs(percent));
    if (sizes.empty()) return 1.0;
    std::sort(sizes.begin(), sizes.end());
    const double most = sizes.back(), usual = sizes[sizes.size() - 1 - sizes.size() / 32];
    constexpr double kLeast = 1e-9;  // both are the same but for rounding
    const double reach = std::max(most < 2.0 * usual ? most : usual, kLeast);
    const double power = std::pow(10.0, std::floor(std::log10(reach)));
    for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (factor * power >= reach) return factor * power;
    return 10.0 * power;
}

bool plotsDifference(const AppState& state) {
    if (!state.shows(View::difference) || !state.shows(View::profile) || !state.scene->visibility)
        return false;
    const bool known = state.answer && state.answer->exactPictures[0].profile;
    return known || !lightIsComplete(state);
}

}  // namespace halfdisk
