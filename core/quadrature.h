// What is the integral of a function with kinks? Adaptive Gauss-Legendre quadrature: a panel is halved until
// its two halves agree with it.
#pragma once

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

/// Integrals of f over [from, to], to about `tolerance` each. Gives up halving after `halvings` levels, where
/// a jump is enclosed to 2^-halvings of the interval.
template <std::size_t Count, class Function>
Integrals<Count> integrate(const Function& f, double from, double to, double tolerance, int halvings = 36) {
    struct Panel {
        const Function& f;
        double tolerance;

        Integrals<Count> refine(double a, double b, const Integrals<Count>& whole, int left) const {
            const double middle = a + (b - a) / 2;
            const Integrals<Count> low = gaussPanel<Count>(f, a, middle),
                                   high = gaussPanel<Count>(f, middle, b);
            Integrals<Count> sum;
            bool agreed = true;
            for (std::size_t i = 0; i < Count; ++i) {
                sum[i] = low[i] + high[i];
                agreed = agreed && std::abs(sum[i] - whole[i]) <= tolerance;
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

}  // namespace halfdisk
