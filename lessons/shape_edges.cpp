// Which walls does a shape consist of, where do they meet, and which way do they curve?
#include "lessons/shape_edges.h"

#include <algorithm>
#include <cmath>

#include "lessons/lens.h"

namespace halfdisk {
namespace {

/// `v` turned by `quarters` right angles, without rounding.
Vec2 turnedByQuarters(Vec2 v, std::uint64_t quarters) {
    switch (quarters % 4) {
        case 1:
            return {-v.y, v.x};
        case 2:
            return {-v.x, -v.y};
        case 3:
            return {v.y, -v.x};
        default:
            return v;
    }
}

bool isFullTurn(const ArcShape& arc) {
    return std::abs(arc.to - arc.from) >= 360.0 - (kMaxSweep - 360.0);
}

struct EdgeCounter {
    std::uint64_t operator()(const SegmentShape&) const { return 1; }
    std::uint64_t operator()(const PolylineShape& s) const {
        return s.points.empty() ? 0 : s.points.size() - 1;
    }
    std::uint64_t operator()(const PolygonShape& s) const { return s.points.size(); }
    std::uint64_t operator()(const BoxShape&) const { return 4; }
    std::uint64_t operator()(const CircleShape& s) const { return s.segments; }
    std::uint64_t operator()(const ArcShape& s) const { return s.segments; }
    std::uint64_t operator()(const LensShape& s) const { return lensEdgeCount(s); }
};

/// Walls along a chain of vertices; the last one ends at the first vertex if `closed`.
std::vector<Edge> chain(const std::vector<Vec2>& vertices, bool closed, bool reversed) {
    std::vector<Edge> edges;
    const std::size_t count = closed ? vertices.size() : vertices.size() - 1;
    edges.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2 start = vertices[k];
        const Vec2 end = vertices[(k + 1) % vertices.size()];
        edges.push_back(reversed ? Edge{end, start} : Edge{start, end});
    }
    return edges;
}

/// Walls along vertices on a circle, of which the unit vectors from its middle are given, in either sense.
template <class Round>
std::vector<Edge> roundChain(const Round& shape, const std::vector<Vec2>& units, bool closed, bool reversed) {
    std::vector<Vec2> vertices;
    vertices.reserve(units.size());
    for (const Vec2 unit : units) vertices.push_back(shape.center + shape.radius * unit);
    std::vector<Edge> edges = chain(vertices, closed, reversed);
    if (!shape.smooth) return edges;
    const double sign = shape.facing == Facing::out ? 1.0 : -1.0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const Vec2 start = sign * units[k];
        const Vec2 end = sign * units[(k + 1) % units.size()];
        edges[k].normalA = reversed ? end : start;
        edges[k].normalB = reversed ? start : end;
    }
    return edges;
}

struct EdgeMaker {
    std::vector<Edge> operator()(const SegmentShape& s) const { return {{s.a, s.b}}; }
    std::vector<Edge> operator()(const PolylineShape& s) const {
        return s.points.empty() ? std::vector<Edge>{} : chain(s.points, false, false);
    }
    std::vector<Edge> operator()(const PolygonShape& s) const { return chain(s.points, true, false); }
    std::vector<Edge> operator()(const BoxShape& s) const {
        return chain({s.min, {s.max.x, s.min.y}, s.max, {s.min.x, s.max.y}}, true, s.facing == Facing::out);
    }
    std::vector<Edge> operator()(const CircleShape& s) const {
        std::vector<Vec2> units;
        units.reserve(s.segments);
        for (std::uint32_t k = 0; k < s.segments; ++k) units.push_back(unitAtFraction(k, s.segments));
        // Counter-clockwise, so the left of k -> k + 1 is the inside.
        return roundChain(s, units, true, s.facing == Facing::out);
    }
    std::vector<Edge> operator()(const ArcShape& s) const {
        const bool full = isFullTurn(s);
        const double sweep = s.to - s.from;
        std::vector<Vec2> units;
        units.reserve(s.segments + std::size_t{1});
        for (std::uint32_t k = 0; k < s.segments; ++k)
            units.push_back(unitAtDegrees(s.from + sweep * k / s.segments));
        if (!full) units.push_back(unitAtDegrees(s.to));
        const bool leftIsInside = sweep > 0.0;
        return roundChain(s, units, full, (s.facing == Facing::in) != leftIsInside);
    }
    std::vector<Edge> operator()(const LensShape& s) const { return lensEdges(s); }
};

}  // namespace

Vec2 unitAtFraction(std::uint32_t k, std::uint32_t count) {
    const std::uint64_t quarterTurns = std::uint64_t{4} * k;
    const std::uint64_t rest = quarterTurns % count;  // angle within its quarter: pi / 2 * rest / count
    const auto angle = [&](std::uint64_t part) {
        return kPi / 2 * static_cast<double>(part) / static_cast<double>(count);
    };
    Vec2 unit;
    if (2 * rest == count) {
        unit = Vec2(std::sqrt(0.5));
    } else if (2 * rest < count) {
        unit = {std::cos(angle(rest)), std::sin(angle(rest))};
    } else {
        unit = {std::sin(angle(count - rest)), std::cos(angle(count - rest))};
    }
    return turnedByQuarters(unit, quarterTurns / count);
}

Vec2 unitAtDegrees(double degrees) {
    double positive = std::fmod(degrees, 360.0);
    if (positive < 0.0) positive += 360.0;
    const double quarters = std::floor(positive / 90.0);
    const double rest = (positive - 90.0 * quarters) * (kPi / 180.0);
    return turnedByQuarters({std::cos(rest), std::sin(rest)}, static_cast<std::uint64_t>(quarters));
}

bool isZeroLength(Vec2 a, Vec2 b) {
    // Each coordinate carries a rounding error of up to 1.1e-16 of its size: a length below some 50 of those
    // has a direction that is wrong by degrees. The absolute bound keeps the square of the length above
    // underflow.
    constexpr double kRelative = 5e-15;
    constexpr double kAbsolute = 1e-100;
    const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return !(length > std::max(kAbsolute, kRelative * size));
}

std::uint64_t edgeCount(const Geometry& geometry) {
    return std::visit(EdgeCounter{}, geometry);
}

std::vector<Edge> edgesOf(const Geometry& geometry) {
    return std::visit(EdgeMaker{}, geometry);
}

Vec2 unitAlong(Vec2 direction) {
    // Scaled first, so that squares neither overflow nor vanish.
    return glm::normalize(direction / std::max(std::abs(direction.x), std::abs(direction.y)));
}

}  // namespace halfdisk
