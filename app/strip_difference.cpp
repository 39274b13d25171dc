#include "app/strip_difference.h"

#include <algorithm>
#include <cmath>

#include "app/false_color.h"
#include "app/tone.h"

namespace halfdisk {
namespace {

/// Shares of white that the full colour can stand for.
constexpr std::array kFullShares{0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5};

/// From paper to orange (1) or blue (-1).
std::uint32_t differenceColor(double share) {
    constexpr std::array<double, 3> kPaper{0xfb, 0xf9, 0xf4}, kMore{0xd5, 0x5e, 0x00},
        kLess{0x00, 0x5b, 0x9e};
    const auto& end = share > 0.0 ? kMore : kLess;
    const double part = std::min(1.0, std::abs(share));
    std::array<std::uint8_t, 3> color{};
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<std::uint8_t>(std::lround(kPaper[i] + part * (end[i] - kPaper[i])));
    return packed(color[0], color[1], color[2]);
}

std::vector<double> differences(const LightPicture& picture, const std::vector<Rgb>& exact) {
    std::vector<double> all;
    for (std::size_t i = 0; i < exact.size(); ++i)
        all.push_back(gray(picture.film.pixels.mean[i]) - gray(exact[i]));
    return all;
}

/// Nearly all lie within it.
double fullShare(const std::vector<double>& all, double white) {
    std::vector<double> sizes;
    for (const double difference : all) sizes.push_back(std::abs(difference) / white);
    std::sort(sizes.begin(), sizes.end());
    const double most = sizes.empty() ? 0.0 : sizes[sizes.size() - 1 - sizes.size() / 20];
    for (const double share : kFullShares)
        if (most <= share) return share;
    return 1.0;
}

}  // namespace

StripDifferences stripDifferences(const AppState& state) {
    StripDifferences found;
    if (!state.shows(View::difference) || !state.answer) return found;
    const LightAnswer& answer = *state.answer;
    std::array<std::vector<double>, 2> all;
    std::vector<double> both;
    double white = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
        const auto& picture = (side == 0 ? answer.pictures : answer.against).eye;
        const auto& exact = answer.exactPictures[side].eye;
        if (!picture || !exact || picture->film.pixels.size() != exact->size()) continue;
        all[side] = differences(*picture, *exact);
        both.insert(both.end(), all[side].begin(), all[side].end());
        white = picture->white;
    }
    const auto& shown =
        answer.exactPictures[0].eye ? answer.exactPictures[0].eye : answer.exactPictures[1].eye;
    if (!shown || both.empty()) return found;
    const double scale = white > 0.0 ? 1.0 / white : 1.0;
    for (const Rgb& L : *shown)
        found.exact.push_back(packed(srgbByte(scale * L.x), srgbByte(scale * L.y), srgbByte(scale * L.z)));
    const double share = fullShare(both, 1.0 / scale);
    found.share = white > 0.0 ? share : 0.0;
    found.full = share / scale;
    for (std::size_t side = 0; side < 2; ++side)
        for (const double difference : all[side])
            found.difference[side].push_back(differenceColor(difference / found.full));
    return found;
}

}  // namespace halfdisk
