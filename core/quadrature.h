// What is the integral of a function with kinks? Adaptive Gauss-Legendre quadrature: a panel is halved until
// its two halves agree with it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace halfdisk {

/// Nodes (in (-1, 1)) and weights of the 8-point rule; exact for polynomials up to degree 15 (Abramowitz &
/// Stegun, 25.4.30).
struct GaussPoint {
    double x, weight;
};
inline constexpr std::array<GaussPoint, 8> kGauss8{{
    {-0.96028985649753623, 0.10122853629037626},
    {-0.79666647741362674, 0.22238103445337447},
    {-0.52553240991632899, 0.31370664587788729},
    {-0.18343464249564980, 0.36268378337836198},
    {0.18343464249564980, 0.36268378337836198},
    {0.52553240991632899, 0.31370664587788729},
    {0.79666647741362674, 0.22238103445337447},
    {0.96028985649753623, 0.10122853629037626},
}};

/// A fixed number of integrals done at the same nodes.
template <std::size_t Count>
using Integrals = std::array<double, Count>;

template <std::size_t Count, class Function>
Integrals<Count> gaussPanel(const Function& f, double from, double to) {
    Integrals<Count> sum{};
    const double half = (to - from) / 2, middle = from + half;
    for (const GaussPoint& point : kGauss8) {
        const Integrals<Count> value = f(middle + half * point.x);
        for (std::size_t i = 0; i < Count; ++i) sum[i] += half * point.weight * value[i];
    }
    return sum;
}

/// Integrals of f over [from, to], each to about its `tolerance`. Gives up halving after `halvings` levels,
/// where a jump is enclosed to 2^-halvings of the interval.
template <std::size_t Count, class Function>
Integrals<Count> integrate(const Function& f, double from, double to, const Integrals<Count>& tolerance,
                           int halvings) {
    // A smooth panel ends by this whatever the tolerance, so only those with a kink are halved to the last.
    constexpr double kRounding = 1e-13;
    struct Panel {
        const Function& f;
        const Integrals<Count>& tolerance;

        Integrals<Count> refine(double a, double b, const Integrals<Count>& whole, int left) const {
            const double middle = a + (b - a) / 2;
            const Integrals<Count> low = gaussPanel<Count>(f, a, middle),
                                   high = gaussPanel<Count>(f, middle, b);
            Integrals<Count> sum;
            bool agreed = true;
            for (std::size_t i = 0; i < Count; ++i) {
                sum[i] = low[i] + high[i];
                const double enough = std::max(tolerance[i], kRounding * std::abs(sum[i]));
                agreed = agreed && std::abs(sum[i] - whole[i]) <= enough;
            }
            if (agreed || left == 0) return sum;
            const Integrals<Count> first = refine(a, middle, low, left - 1),
                                   second = refine(middle, b, high, left - 1);
            for (std::size_t i = 0; i < Count; ++i) sum[i] = first[i] + second[i];
            return sum;
        }
    };
    return Panel{f, tolerance}.refine(from, to, gaussPanel<Count>(f, from, to), halvings);
}

/// Sum of the integrals of f >= 0 over all `pieces` (anything with `from` and `to`), each to about `relative`
/// times itself.
template <std::size_t Count, class Pieces, class Function>
Integrals<Count> integrateOver(const Pieces& pieces, const Function& f, double relative, int halvings) {
    Integrals<Count> tolerance{}, sum{};
    for (const auto& piece : pieces) {
        const Integrals<Count> rough = gaussPanel<Count>(f, piece.from, piece.to);
        for (std::size_t i = 0; i < Count; ++i) tolerance[i] += relative * std::abs(rough[i]);
    }
    for (const auto& piece : pieces) {
        const Integrals<Count> part = integrate<Count>(f, piece.from, piece.to, tolerance, halvings);
        for (std::size_t i = 0; i < Count; ++i) sum[i] += part[i];
    }
    return sum;
}

}  // namespace halfdisk
