#include "float_fit.h"

#include <algorithm>

namespace halfdisk {
namespace {

Vec2 inFloat(Vec2 p) {
    return {static_cast<double>(static_cast<float>(p.x)), static_cast<double>(static_cast<float>(p.y))};
}

}  // namespace

FloatFit floatFitOf(const Scene& scene) {
    FloatFit fit;
    for (const Segment& s : scene.segments) {
        const Vec2 a = inFloat(s.a), b = inFloat(s.b);
        const double moved = std::max(glm::length(a - s.a), glm::length(b - s.b));
        fit.rounding = std::max(fit.rounding, moved);
        // Not <=: a coordinate beyond float's range makes NaN.
        if (moved <= kMostBent * glm::length(s.b - s.a)) continue;
        ++fit.bent;
        if (a == b) ++fit.lost;
    }
    return fit;
}

}  // namespace halfdisk
