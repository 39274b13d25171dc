// Rows of glass: hardly any, a lot, and at the critical angle.
#include <algorithm>

#include "core/extremes/rows.h"
#include "core/materials/dielectric.h"

namespace halfdisk {
namespace {

struct Split {
    long double reflected = 1.0L, cosine = 0.0L;
};

/// Fresnel's equations in long double, for the very same numbers.
Split trueSplit(double cosine, double n1, double n2) {
    const long double c = cosine, ratio = static_cast<long double>(n1) / n2;
    const long double square = 1.0L - ratio * ratio * (1.0L - c) * (1.0L + c);
    if (!(square > 0.0L)) return {};
    const long double t = std::sqrt(square);
    const long double s = (n1 * c - n2 * t) / (n1 * c + n2 * t), p = (n2 * c - n1 * t) / (n2 * c + n1 * t);
    return {(s * s + p * p) / 2.0L, t};
}

/// The same in `Real`, by angles, as it stands in optics books: sin(i - t) / sin(i + t), tan(i - t) / tan(i +
/// t).
template <class Real>
Refraction naiveSplit(double cosine, double n1, double n2) {
    const Real i = std::acos(static_cast<Real>(cosine));
    const Real t = std::asin(static_cast<Real>(n1) / static_cast<Real>(n2) * std::sin(i));
    const Real s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
    return {static_cast<double>((s * s + p * p) / 2), static_cast<double>(std::cos(t))};
}

/// How well a way to split light does over all angles. An error of the refracted cosine t is h / t, and moves
/// the reflected share by h / (c t): both cosines weigh the errors.
template <class Ask>
ExtremeSide sideOf(double n1, double n2, const Ask& ask) {
    ExtremeSide side;
    for (int k = 0; k <= 2000; ++k) {
        const double c = k <= 1000 ? k / 1000.0 : std::pow(10.0, -6.0 * (k - 1000) / 1000.0);
        if (c == 0.0) continue;
        const Split truth = trueSplit(c, n1, n2);
        const Refraction said = ask(c);
        ++side.counts.rays;
        if (!std::isfinite(said.reflected) || !std::isfinite(said.cosine)) {
            ++side.counts.nonFinite;
            continue;
        }
        const double weight = c * static_cast<double>(truth.cosine);
        const double off = std::max(std::abs(static_cast<double>(said.reflected - truth.reflected)),
                                    std::abs(static_cast<double>(said.cosine - truth.cosine)));
        side.error = std::max(side.error, truth.cosine == 0.0L ? off : off * weight);
    }
    return side;
}

// square = 1 - r^2 (1 - c)(1 + c): six roundings of numbers up to r^2 (at most 1 where light passes, since
// r sin <= 1), so its root t is off by 3 h / t. s and p: their numerators by h n c + h n t and what t is off
// by, over the sum of the same two: 2 (3 h / t + 2 h) / c at most; the squares' mean twice that: 16 h / (c
// t), and a few more.
constexpr double kGlassBound = 24.0 * kRounding;

ExtremeCell splitCell(const char* id, std::string title, double n1, double n2) {
    return {id,
            std::move(title),
            "R and cosine, by c t",
            kGlassBound,
            "some ten roundings, which 1 / (c t) makes larger next to grazing",
            [n1, n2](const StopQuestion&) {
                ExtremeOutcome outcome;
                outcome.ours = sideOf(n1, n2, [&](double c) { return refraction(c, n1, n2); });
                outcome.naiveFloat = sideOf(n1, n2, [&](double c) { return naiveSplit<float>(c, n1, n2); });
                outcome.naiveDouble = sideOf(n1, n2, [&](double c) { return naiveSplit<double>(c, n1, n2); });
                return outcome;
            }};
}

/// Total reflection is R = 1 and no cosine; else it is the cosine's relative error that counts.
ExtremeSide criticalSide(const Refraction& said, const Split& truth) {
    ExtremeSide side;
    side.counts.rays = 1;
    if (!std::isfinite(said.reflected) || !std::isfinite(said.cosine)) side.counts.nonFinite = 1;
    side.error = truth.cosine == 0.0L
                     ? std::abs(said.reflected - 1.0) + std::abs(said.cosine)
                     : std::abs(static_cast<double>((said.cosine - truth.cosine) / truth.cosine));
    return side;
}

// Beyond the angle nothing may pass: exact. Below it square = 2e-6 tan(critical) n^2 cos^2 = 2.2e-6, off by 3
// h: the root by half of 3 h / 2.2e-6.
ExtremeCell criticalCell(const char* id, double beyond) {
    constexpr double kIor = 1.5;
    return {id,
            beyond > 0.0 ? "glass, 1e-6 rad beyond the critical angle"
                         : "glass, 1e-6 rad short of the critical angle",
            beyond > 0.0 ? "R and cosine" : "cosine, relative",
            beyond > 0.0 ? 0.0 : 6.0 * kRounding / 2.2e-6,
            beyond > 0.0 ? "total reflection is total" : "1 - n^2 sin^2 is 2.2e-6, and off by some roundings",
            [beyond](const StopQuestion&) {
                const long double angle = std::asin(1.0L / static_cast<long double>(kIor)) + beyond;
                const auto cosine = static_cast<double>(std::cos(angle));
                const Split truth = trueSplit(cosine, kIor, 1.0);
                ExtremeOutcome outcome;
                outcome.ours = criticalSide(refraction(cosine, kIor, 1.0), truth);
                outcome.naiveFloat = criticalSide(naiveSplit<float>(cosine, kIor, 1.0), truth);
                outcome.naiveDouble = criticalSide(naiveSplit<double>(cosine, kIor, 1.0), truth);
                return outcome;
            }};
}

}  // namespace

void addGlassRows(std::vector<ExtremeCell>& cells) {
    constexpr double kHardly = 1.0 + 1e-6;
    cells.push_back(splitCell("ior:1", "glass of index 1, which is none", 1.0, 1.0));
    cells.push_back(splitCell("ior:1+1e-6", "light into glass of index 1 + 1e-6", 1.0, kHardly));
    cells.push_back(splitCell("ior:1-1e-6", "light out of glass of index 1 + 1e-6", kHardly, 1.0));
    cells.push_back(splitCell("ior:4", "light into glass of index 4", 1.0, 4.0));
    cells.push_back(splitCell("ior:1/4", "light out of glass of index 4", 4.0, 1.0));
    cells.push_back(criticalCell("critical:-1e-6", -1e-6));
    cells.push_back(criticalCell("critical:+1e-6", 1e-6));
}

}  // namespace halfdisk
