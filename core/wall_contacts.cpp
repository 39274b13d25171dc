#include "wall_contacts.h"

#include <algorithm>

namespace halfdisk {
namespace {

bool isLeftOf(Vec2 a, Vec2 b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

void addCrossing(const Segment& s, const Segment& other, std::vector<Vec2>& points) {
    const Vec2 e = s.b - s.a, f = other.b - other.a;
    const double denominator = cross(e, f);
    if (denominator == 0.0) return;
    const double u = cross(other.a - s.a, f) / denominator, v = cross(other.a - s.a, e) / denominator;
    if (u > 0.0 && u < 1.0 && v > 0.0 && v < 1.0) points.push_back(s.a + u * e);
}

bool shareHeight(const Segment& s, const Segment& other) {
    return std::min(s.a.y, s.b.y) <= std::max(other.a.y, other.b.y) &&
           std::min(other.a.y, other.b.y) <= std::max(s.a.y, s.b.y);
}

}  // namespace

std::vector<Vec2> cornersOf(const std::vector<Segment>& walls, const StopQuestion& stop) {
    std::vector<Vec2> corners;
    std::vector<const Segment*> fromLeft;
    for (const Segment& wall : walls) {
        corners.push_back(wall.a);
        corners.push_back(wall.b);
        fromLeft.push_back(&wall);
    }
    const auto left = [](const Segment* wall) { return std::min(wall->a.x, wall->b.x); };
    const auto right = [](const Segment* wall) { return std::max(wall->a.x, wall->b.x); };
    std::sort(fromLeft.begin(), fromLeft.end(), [&](const Segment* one, const Segment* other) {
        return left(one) != left(other) ? left(one) < left(other) : one < other;
    });
    for (std::size_t i = 0; i < fromLeft.size(); ++i) {
        throwIfStopped(stop, i);
        for (std::size_t k = i + 1; k < fromLeft.size() && left(fromLeft[k]) <= right(fromLeft[i]); ++k)
            if (shareHeight(*fromLeft[i], *fromLeft[k])) addCrossing(*fromLeft[i], *fromLeft[k], corners);
    }
    std::sort(corners.begin(), corners.end(), isLeftOf);
    return corners;
}

std::vector<double> contactsOf(const Segment& wall, const std::vector<Vec2>& corners) {
    constexpr double kOnWall = 1e-9;  // of the wall's length
    const Vec2 edge = wall.b - wall.a;
    const double squared = glm::dot(edge, edge), reach = kOnWall * std::sqrt(squared);
    const auto first = std::lower_bound(corners.begin(), corners.end(), std::min(wall.a.x, wall.b.x) - reach,
                                        [](Vec2 corner, double x) { return corner.x < x; });
    std::vector<double> places{0.0, 1.0};
    for (auto corner = first; corner != corners.end() && corner->x <= std::max(wall.a.x, wall.b.x) + reach;
         ++corner) {
        if (std::abs(cross(*corner - wall.a, edge)) > kOnWall * squared) continue;
        const double u = glm::dot(*corner - wall.a, edge) / squared;
        if (u > kOnWall && u < 1.0 - kOnWall) places.push_back(u);
    }
    std::sort(places.begin(), places.end());
    const auto same = [](double u, double v) { return v - u <= kOnWall; };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
    return places;
}

}  // namespace halfdisk
