// How do two curvatures, a height and a thickness become a lens, and when can there be none?
//
// In the lens's own frame x runs along the axis and y to the left of it, from its middle.
#include "lessons/lens.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

/// How deep a surface of this radius is at y from the axis (m): above 0 towards the middle of the lens.
double sagitta(double radius, double y) {
    if (radius == 0.0) return 0.0;
    const double r = std::abs(radius);
    const double depth = y * (y / (r + std::sqrt((r - y) * (r + y))));
    return radius > 0.0 ? depth : -depth;
}

/// A surface in the lens's frame, from its lower rim to its upper one.
struct Surface {
    std::vector<Vec2> points;
    std::vector<Vec2> normals;  ///< outward; none on a flat surface
};

/// `side`: -1 for the surface at -axis, 1 for the other one.
Surface surfaceOf(const LensShape& lens, double side) {
    const double radius = side < 0.0 ? lens.radius.x : lens.radius.y;
    const double apex = lens.thickness / 2, top = lens.height / 2;
    const double rim = hasRim(lens)
                           ? side * (apex - sagitta(radius, top))
                           : (sagitta(lens.radius.x, top) - sagitta(lens.radius.y, top)) / 2;  // one for both
    if (radius == 0.0) return {{{rim, -top}, {rim, top}}, {}};

    const double most = std::asin(std::min(1.0, top / std::abs(radius)));
    const double bend = radius > 0.0 ? 1.0 : -1.0;
    Surface surface;
    surface.points.reserve(lens.segments + std::size_t{1});
    surface.normals.reserve(lens.segments + std::size_t{1});
    for (std::uint32_t k = 0; k <= lens.segments; ++k) {
        // An odd function of k about the middle, so that the lens is symmetric to the last bit.
        const double steps = 2.0 * k - lens.segments;
        const double angle = most * (steps / lens.segments);
        const double y = std::abs(radius) * std::sin(angle);
        const double half = std::sin(angle / 2);
        surface.points.emplace_back(side * (apex - radius * 2.0 * half * half), y);
        surface.normals.emplace_back(side * std::cos(angle), bend * std::sin(angle));
    }
    surface.points.front() = {rim, -top};
    surface.points.back() = {rim, top};
    return surface;
}

/// x at height y of a surface, on its facet k; `k` is moved on to the facet that y lies on.
double facetAt(const std::vector<Vec2>& points, double y, std::size_t& k) {
    while (k + 2 < points.size() && points[k + 1].y < y) ++k;
    const Vec2 low = points[k], high = points[k + 1];
    return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
}

/// Whether all points but the first and the last lie beside `other`: to the right of it, or with `side` -1 to
/// the left.
bool lieBeside(const std::vector<Vec2>& points, const std::vector<Vec2>& other, double side) {
    std::size_t facet = 0;
    for (std::size_t k = 1; k + 1 < points.size(); ++k)
        if (!(side * (points[k].x - facetAt(other, points[k].y, facet)) > 0.0)) return false;
    return true;
}

}  // namespace

double rimThickness(const LensShape& lens) {
    const double top = lens.height / 2;
    return lens.thickness - sagitta(lens.radius.x, top) - sagitta(lens.radius.y, top);
}

bool hasRim(const LensShape& lens) {
    return !(std::abs(rimThickness(lens)) <= 1e-9 * lens.height);
}

bool facetsCross(const LensShape& lens) {
    const Surface before = surfaceOf(lens, -1.0), after = surfaceOf(lens, 1.0);
    return !lieBeside(after.points, before.points, 1.0) || !lieBeside(before.points, after.points, -1.0);
}

std::uint64_t lensEdgeCount(const LensShape& lens) {
    const auto edges = [&](double radius) { return radius == 0.0 ? std::uint64_t{1} : lens.segments; };
    return edges(lens.radius.x) + edges(lens.radius.y) + (hasRim(lens) ? 2 : 0);
}

std::vector<Edge> lensEdges(const LensShape& lens) {
    const Vec2 along = unitAlong(lens.axis), across = perp(along);
    const auto toWorld = [&](Vec2 v) { return v.x * along + v.y * across; };
    std::vector<Edge> edges;
    edges.reserve(lensEdgeCount(lens));
    const auto addSurface = [&](Surface surface, bool upward) {
        if (!upward) {
            std::reverse(surface.points.begin(), surface.points.end());
            std::reverse(surface.normals.begin(), surface.normals.end());
        }
        for (std::size_t k = 0; k + 1 < surface.points.size(); ++k) {
            Edge edge{lens.center + toWorld(surface.points[k]), lens.center + toWorld(surface.points[k + 1])};
            if (lens.smooth && !surface.normals.empty()) {
                edge.normalA = toWorld(surface.normals[k]);
                edge.normalB = toWorld(surface.normals[k + 1]);
            }
            edges.push_back(edge);
        }
    };
    const bool rim = hasRim(lens);
    addSurface(surfaceOf(lens, -1.0), true);
    const Edge left = edges.front(), leftTop = edges.back();
    const std::size_t upperRim = edges.size();
    if (rim) edges.emplace_back();
    addSurface(surfaceOf(lens, 1.0), false);
    if (!rim) return edges;
    edges[upperRim] = {leftTop.b, edges[upperRim + 1].a};
    edges.push_back({edges.back().b, left.a});
    return edges;
}

}  // namespace halfdisk
