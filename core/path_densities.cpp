#include "path_densities.h"

namespace halfdisk {

WholePath::WholePath(const LightTable& lights, const LightEnd& light, std::span<const InnerVertex> inner,
                     const Receiver& receiver, double pdfReceiver)
    : lights_(lights), light_(light), inner_(inner), receiver_(receiver), pdfReceiver_(pdfReceiver) {}

Vec2 WholePath::direction(std::size_t from, std::size_t to) const {
    if (to == 0 && light_.infinite) return light_.towards;
    if (from == 0 && light_.infinite) return -light_.towards;
    const auto place = [&](std::size_t i) {
        return i == 0 ? light_.P : i <= inner_.size() ? inner_[i - 1].at.P : receiver_.at.P;
    };
    return glm::normalize(place(to) - place(from));
}

double WholePath::perMetre(double pdfAngle, std::size_t from, std::size_t to) const {
    if (to == 0 && light_.infinite) return pdfAngle;
    const Vec2 N = to == 0 ? light_.N : to <= inner_.size() ? inner_[to - 1].at.N : receiver_.at.N;
    const Vec2 a = from <= inner_.size() ? inner_[from - 1].at.P : receiver_.at.P;
    const Vec2 b = to == 0 ? light_.P : to <= inner_.size() ? inner_[to - 1].at.P : receiver_.at.P;
    const double r = glm::length(b - a);
    return r > 0.0 ? pdfAngle * std::abs(glm::dot(N, b - a)) / (r * r) : 0.0;
}

// Density of x_i given what lies on the light's side of it.
double WholePath::fromLight(std::size_t i) const {
    const bool lamp = light_.segment != kNoSegment;
    if (i == 0) {
        const double picked = lights_.probability(light_.light);
        if (lamp) return picked * lights_.pdfPositionOf(light_.light);
        return light_.canBeMet ? picked * lights_.pdfEnvironment(light_.towards) : picked;
    }
    if (i == 1) {
        const Vec2 N = inner_.empty() ? receiver_.at.N : inner_[0].at.N;
        const Vec2 P = inner_.empty() ? receiver_.at.P : inner_[0].at.P;
        if (light_.infinite)
            return std::abs(glm::dot(N, light_.towards)) * lights_.pdfPositionOf(light_.light);
        const Vec2 gap = P - light_.P;
        const double r = glm::length(gap);
        if (r == 0.0) return 0.0;
        double pdfAngle = 1.0 / (2.0 * kPi);
        if (lamp) {
            const bool twoSided = lights_.index().scene().segments[light_.segment].twoSided;
            pdfAngle = std::max(0.0, glm::dot(light_.N, gap)) / (r * (twoSided ? 4.0 : 2.0));
        }
        return pdfAngle * std::abs(glm::dot(N, gap)) / (r * r);
    }
    const InnerVertex& before = inner_[i - 2];
    const double pdfAngle =
        before.delta ? 1.0 : pdfSurface(before.at, direction(i - 1, i - 2), direction(i - 1, i));
    return perMetre(pdfAngle, i - 1, i);
}

// Density of x_i given what lies on the sensor's side of it.
double WholePath::fromSensor(std::size_t i) const {
    const std::size_t last = inner_.size() + 1;
    if (i == last) return pdfReceiver_;
    if (i + 1 == last) {
        const Vec2 away = direction(last, i);
        // An eye draws within a pixel just as it weighs.
        const double pdfAngle = receiver_.weighing == Weighing::film  ? responseTo(receiver_, away).weight
                                : receiver_.weighing == Weighing::one ? 1.0
                                                                      : pdfSight(receiver_, away);
        return perMetre(pdfAngle, last, i);
    }
    const InnerVertex& before = inner_[i];
    const double pdfAngle =
        before.delta ? 1.0 : pdfSurface(before.at, direction(i + 1, i + 2), direction(i + 1, i));
    return perMetre(pdfAngle, i + 1, i);
}

double WholePath::countOf(std::size_t s, const StrategyCounts& counts) const {
    if (s == 0) return light_.canBeMet ? 1.0 : 0.0;
    if (s == size()) return counts.lightAlone;
    if (isDelta(s - 1) || isDelta(s)) return 0.0;
    return s + 1 == size() ? counts.lightConnected : 1.0;
}

double WholePath::weight(std::size_t s, const StrategyCounts& counts, Heuristic heuristic) const {
    // Densities relative to that of strategy s, from it towards both ends: each step swaps one vertex's side.
    const auto share = [&](double count, double relative) {
        const double density = count / countOf(s, counts) * relative;
        return heuristic == Heuristic::balance ? density : density * density;
    };
    double sum = 1.0, relative = 1.0;
    for (std::size_t i = s; i < size(); ++i) {
        const double mine = fromSensor(i);
        if (!(mine > 0.0)) return 0.0;  // by rounding, at the very edge of a lobe or of a wall
        relative *= fromLight(i) / mine;
        sum += share(countOf(i + 1, counts), relative);
    }
    relative = 1.0;
    for (std::size_t i = s; i-- > 0;) {
        const double mine = fromLight(i);
        if (!(mine > 0.0)) return 0.0;
        relative *= fromSensor(i) / mine;
        sum += share(countOf(i, counts), relative);
    }
    return 1.0 / sum;
}

}  // namespace halfdisk
