// Can the colours be read, and told apart, also by readers with the common kinds of colour blindness?
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "app/theme.h"

using namespace halfdisk;

namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

/// Full dichromacy, on linear RGB (Machado, Oliveira and Fernandes 2009, severity 1).
constexpr Matrix kNormal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

Vector times(const Matrix& m, const Vector& v) {
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

Vector linear(ImU32 color) {
    const auto channel = [&](int shift) {
        const double c = ((color >> shift) & 255u) / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT)};
}

/// CIE L*a*b* of linear sRGB under D65.
Vector lab(const Vector& rgb) {
    constexpr Matrix kToXyz{{{0.4124564, 0.3575761, 0.1804375},
                             {0.2126729, 0.7151522, 0.0721750},
                             {0.0193339, 0.1191920, 0.9503041}}};
    constexpr Vector kWhite{0.95047, 1.0, 1.08883};
    const Vector xyz = times(kToXyz, rgb);
    Vector f{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = std::max(0.0, xyz[i] / kWhite[i]);
        f[i] = t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    }
    return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

/// Delta E (CIE 1976): 2.3 is just noticeable side by side.
double difference(ImU32 a, ImU32 b, const Matrix& eye) {
    const Vector la = lab(times(eye, linear(a))), lb = lab(times(eye, linear(b)));
    return std::hypot(la[0] - lb[0], la[1] - lb[1], la[2] - lb[2]);
}

/// Eight times what is just noticeable: enough for thin lines that do not touch.
constexpr double kLeastDifference = 18.0;

struct Pair {
    std::string what;
    ImU32 a, b;
};

}  // namespace

TEST_CASE("the measure of colour difference knows black, white and the confusion of red and green") {
    CHECK(difference(IM_COL32_BLACK, IM_COL32_WHITE, kNormal) == doctest::Approx(100.0).epsilon(0.01));
    CHECK(difference(IM_COL32_BLACK, IM_COL32_WHITE, kDeuteranopia) == doctest::Approx(100.0).epsilon(0.01));
    const ImU32 red = IM_COL32(200, 60, 40, 255), green = IM_COL32(110, 120, 30, 255);
    CHECK(difference(red, green, kDeuteranopia) < 0.5 * difference(red, green, kNormal));
}

TEST_CASE("every colour that words are written in can be read on every ground") {
    const Palette p;
    for (const ImU32 ground : {p.background, p.panel, p.currentLine})
        for (const ImU32 color : {p.ink, p.inkSoft, p.accent, p.error, p.exact, p.estimate, p.normal})
            CHECK(contrast(color, ground) >= 4.5);
    CHECK(contrast(p.panel, p.error) >= 4.5);  // the banner
}

TEST_CASE("what is drawn stands out from the paper") {
    const Palette p;  // WCAG 2.1, 1.4.11: graphical objects need 3 : 1
    CHECK(contrast(p.point, p.background) >= 3.0);
    CHECK(contrast(p.normal, p.background) >= 3.0);
    CHECK(contrast(p.sample, p.background) >= 3.0);
    CHECK(contrast(p.wallFront, p.background) >= 3.0);
    CHECK(contrast(p.shadowRayClear, p.background) >= 3.0);
    CHECK(contrast(p.shadowRayBlocked, p.background) >= 3.0);
}

TEST_CASE("what stands beside each other can be told apart, whatever the eye") {
    const Palette p;
    const Pair pairs[] = {{"bright and dark rays", p.rayBright, p.rayDark},
                          {"clear and blocked shadow rays", p.shadowRayClear, p.shadowRayBlocked},
                          {"bright and clear shadow rays", p.rayBright, p.shadowRayClear},
                          {"bright and blocked shadow rays", p.rayBright, p.shadowRayBlocked},
                          {"dark and clear shadow rays", p.rayDark, p.shadowRayClear},
                          {"dark and blocked shadow rays", p.rayDark, p.shadowRayBlocked},
                          {"exact and estimate", p.exact, p.estimate},
                          {"estimate and sample", p.estimate, p.sample},
                          {"point and sample", p.point, p.sample},
                          {"point and normal", p.point, p.normal},
                          {"exact and point (the curves of the integrand)", p.exact, p.point},
                          {"point and dark ray", p.point, p.rayDark},
                          {"sample and half-disk", p.sample, p.halfDisk}};
    const std::pair<std::string, Matrix> eyes[] = {
        {"normal", kNormal}, {"protanopia", kProtanopia}, {"deuteranopia", kDeuteranopia}};
    for (const Pair& pair : pairs)
        for (const auto& eye : eyes) {
            CAPTURE(pair.what);
            CAPTURE(eye.first);
            CHECK(difference(pair.a, pair.b, eye.second) >= kLeastDifference);
        }
}
