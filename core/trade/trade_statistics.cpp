// What do groups of passes tell of an estimator? Its noise, and its bias with a confidence interval, against
// a truth that may be uncertain itself.
#include "core/trade/trade_statistics.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

double sumOf(const Rgb& value) {
    return value.x + value.y + value.z;
}

/// Sums over all pixels and channels of the groups' differences d_g from the reference's mean.
struct Sums {
    double S2 = 0.0, Q = 0.0;    // of (sum d_g)^2 and sum d_g^2
    std::vector<double> Sd, dd;  // by g: of (sum d) d_g and d_g^2
    double E = 0.0;              // of sum e_r^2 of the reference's groups about their mean
    std::vector<double> de, ee;  // by r: of mean(d) e_r and e_r^2
    double fixed2 = 0.0,
           spread2 = 0.0;  // of a reference with standard errors: their squares; var of the whole
    double mean = 0.0;
    double n = 0.0;
};

Sums sumsOf(const std::vector<Picture>& groups, const TradeReference& reference) {
    const std::size_t G = groups.size(), R = reference.groups.size();
    Sums sums;
    sums.Sd.assign(G, 0.0);
    sums.dd.assign(G, 0.0);
    sums.de.assign(R, 0.0);
    sums.ee.assign(R, 0.0);
    sums.n = 3.0 * static_cast<double>(reference.mean.size());
    for (std::size_t pixel = 0; pixel < reference.mean.size(); ++pixel) {
        const Rgb truth = reference.mean[pixel];
        Rgb S{0.0};
        for (const Picture& group : groups) S += group[pixel] - truth;
        sums.S2 += sumOf(S * S);
        const Rgb mean = S / static_cast<double>(G);
        sums.mean += sumOf(mean + truth) / sums.n;
        for (std::size_t g = 0; g < G; ++g) {
            const Rgb d = groups[g][pixel] - truth;
            sums.Sd[g] += sumOf(S * d);
            sums.dd[g] += sumOf(d * d);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const Rgb e = reference.groups[r][pixel] - truth;
            sums.de[r] += sumOf(mean * e);
            sums.ee[r] += sumOf(e * e);
        }
        if (!reference.standardError.empty()) {
            const Rgb variance = reference.standardError[pixel] * reference.standardError[pixel];
            sums.fixed2 += sumOf(variance);
            sums.spread2 += sumOf(4.0 * mean * mean * variance + 2.0 * variance * variance);
        }
    }
    for (const double dd : sums.dd) sums.Q += dd;
    for (const double ee : sums.ee) sums.E += ee;
    return sums;
}

/// Variance of a statistic by the values that it has without each of the groups.
double jackknife(const std::vector<double>& without) {
    double mean = 0.0, squares = 0.0;
    const double n = static_cast<double>(without.size());
    for (const double value : without) mean += value / n;
    for (const double value : without) squares += (value - mean) * (value - mean);
    return squares * (n - 1.0) / n;
}

/// Root of the sum of all squared covariances of the pixels of the groups' mean, over their number: by the
/// products of different groups' deviations, whose noise is independent.
double effectiveNoise(const std::vector<Picture>& groups) {
    const std::size_t G = groups.size(), pixels = groups.front().size();
    std::vector<Picture> away = groups;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        Rgb mean{0.0};
        for (const Picture& group : groups) mean += group[pixel] / static_cast<double>(G);
        for (Picture& group : away) group[pixel] -= mean;
    }
    double squares = 0.0;
    for (std::size_t g = 0; g < G; ++g)
        for (std::size_t h = g + 1; h < G; ++h) {
            double product = 0.0;
            for (std::size_t pixel = 0; pixel < pixels; ++pixel)
                product += glm::dot(away[g][pixel], away[h][pixel]);
            squares += product * product;
        }
    const double n = static_cast<double>(G), pairs = n * (n - 1.0) / 2.0;
    return std::sqrt(squares / pairs) / (n * 3.0 * static_cast<double>(pixels));
}

}  // namespace

double bias2Low(const TradeStatistics& told, std::uint64_t groups) {
    return told.bias2.value - studentT(static_cast<double>(groups) - 1.0) * told.bias2.error;
}

double bias2High(const TradeStatistics& told, std::uint64_t groups) {
    constexpr double kHidden = 4.0;
    return told.bias2.value + studentT(static_cast<double>(groups) - 1.0) * told.bias2.error +
           kHidden * told.noise;
}

double TradeReference::light() const {
    double sum = 0.0;
    for (const Rgb& pixel : mean) sum += sumOf(pixel);
    return mean.empty() ? 0.0 : sum / (3.0 * static_cast<double>(mean.size()));
}

double studentT(double degrees) {
    return 1.96 + 2.4 / degrees + 3.0 / (degrees * degrees);
}

TradeStatistics statisticsOf(const PassGroups& groups, const TradeReference& reference) {
    const Sums s = sumsOf(groups.means, reference);
    const double G = static_cast<double>(groups.means.size());
    const double R = static_cast<double>(reference.groups.size());
    const double each = static_cast<double>(groups.each);

    // What the reference's own error adds to every square, on average.
    double ofReference = s.fixed2 / s.n;
    double referenceVariance = s.spread2 / (s.n * s.n);
    if (R > 2.0) {
        ofReference = s.E / (R * (R - 1.0)) / s.n;
        std::vector<double> without;
        for (std::size_t r = 0; r < reference.groups.size(); ++r)
            without.push_back((2.0 * s.de[r] / (R - 1.0) + (2.0 * s.ee[r] - s.E) / ((R - 1.0) * (R - 2.0))) /
                              s.n);
        referenceVariance = jackknife(without);
    }

    std::vector<double> biases, variances;
    double mseMean = 0.0, mseSquares = 0.0;
    for (std::size_t g = 0; g < groups.means.size(); ++g) {
        const double S2 = s.S2 - 2.0 * s.Sd[g] + s.dd[g], Q = s.Q - s.dd[g];
        biases.push_back((S2 - Q) / ((G - 1.0) * (G - 2.0)) / s.n);
        variances.push_back((Q - S2 / (G - 1.0)) / (G - 2.0) / s.n);
        mseMean += s.dd[g] / s.n / G;
    }
    for (const double dd : s.dd) mseSquares += (dd / s.n - mseMean) * (dd / s.n - mseMean);

    TradeStatistics told;
    told.mean = s.mean;
    told.noise = effectiveNoise(groups.means);
    told.variance = {each * (s.Q - s.S2 / G) / (G - 1.0) / s.n, each * std::sqrt(jackknife(variances))};
    told.bias2 = {(s.S2 - s.Q) / (G * (G - 1.0)) / s.n - ofReference,
                  std::sqrt(jackknife(biases) + referenceVariance)};
    told.mse = {mseMean - ofReference, std::sqrt(mseSquares / (G * (G - 1.0)) + referenceVariance)};
    return told;
}

std::optional<Uncertain> exponentOf(const std::vector<TradeLevel>& levels) {
    double w = 0.0, wx = 0.0, wy = 0.0, wxx = 0.0, wxy = 0.0;
    std::size_t points = 0;
    const auto isOfUse = [](const TradeLevel& level) {
        return level.mse.value > 0.0 && level.mse.error < 0.5 * level.mse.value;
    };
    const auto sigmaOf = [](const TradeLevel& level) { return 0.5 * level.mse.error / level.mse.value; };
    double most = 0.0;
    for (const TradeLevel& level : levels)
        if (isOfUse(level)) most = std::max(most, sigmaOf(level));
    for (const TradeLevel& level : levels) {
        // Where others have noise, a level without is one where no pass met what is rare: it tells nothing.
        if (!isOfUse(level) || sigmaOf(level) < 1e-4 * most) continue;
        // A curve without any noise has no standard error: all its points are worth the same.
        const double sigma = std::max(sigmaOf(level), 1e-6);
        const double x = std::log(level.passes), y = 0.5 * std::log(level.mse.value);
        const double weight = 1.0 / (sigma * sigma);
        w += weight;
        wx += weight * x;
        wy += weight * y;
        wxx += weight * x * x;
        wxy += weight * x * y;
        ++points;
    }
    const double determinant = w * wxx - wx * wx;
    if (points < 3 || !(determinant > 0.0)) return std::nullopt;
    return Uncertain{(w * wxy - wx * wy) / determinant, std::sqrt(w / determinant)};
}

}  // namespace halfdisk
