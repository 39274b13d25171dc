// Is this a shape whose walls all have a front, although each of its values is fine by itself?
#include "lessons/geometry_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/lens.h"
#include "lessons/shape_edges.h"

namespace halfdisk {
namespace {

using Fault = std::optional<GeometryFault>;

Fault zeroLength(const Geometry& shape, std::string_view key, std::string_view cause) {
    const std::vector<Edge> edges = edgesOf(shape);
    if (std::none_of(edges.begin(), edges.end(), [](const Edge& e) { return isZeroLength(e.a, e.b); }))
        return {};
    return GeometryFault{
        key, {}, fmt::format("{}: a segment of zero length, expected two ends apart from each other", cause)};
}

Fault repeatedPoint(const std::vector<Vec2>& points, const std::vector<Edge>& edges) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
        if (!isZeroLength(edges[k].a, edges[k].b)) continue;
        if (k + 1 == points.size())
            return GeometryFault{
                "points", k,
                "the last point is where the first is: a segment of zero length, expected another "
                "point (a polygon closes by itself)"};
        return GeometryFault{
            "points", k + 1,
            "the point is where the one before it is: a segment of zero length, expected another point"};
    }
    return {};
}

struct FaultFinder {
    Fault operator()(const SegmentShape& s) const { return zeroLength(s, "b", "\"b\" is where \"a\" is"); }
    Fault operator()(const PolylineShape& s) const { return repeatedPoint(s.points, edgesOf(Geometry(s))); }
    Fault operator()(const PolygonShape& s) const { return repeatedPoint(s.points, edgesOf(Geometry(s))); }
    Fault operator()(const BoxShape& s) const {
        if (s.min.x < s.max.x && s.min.y < s.max.y)
            return zeroLength(s, "max", "\"max\" is too close to \"min\"");
        return GeometryFault{
            "max",
            {},
            fmt::format("\"max\" is [{}, {}], expected more than \"min\" = [{}, {}] in both coordinates",
                        s.max.x, s.max.y, s.min.x, s.min.y)};
    }
    Fault operator()(const CircleShape& s) const {
        return zeroLength(s, "radius", "\"radius\" is too small");
    }
    Fault operator()(const ArcShape& s) const {
        const double sweep = std::abs(s.to - s.from);
        if (sweep == 0.0)
            return GeometryFault{"to", {}, "\"to\" equals \"from\", expected an arc of some length"};
        if (sweep > kMaxSweep)
            return GeometryFault{
                "to", {}, fmt::format("the arc spans {} degrees, expected at most 360", sweep)};
        const double most = s.smooth ? kMaxSmoothEdgeSweep : kMaxEdgeSweep;
        if (sweep > most * s.segments)
            return GeometryFault{"segments",
                                 {},
                                 fmt::format("each edge would span {} degrees, expected at most {}{}",
                                             sweep / s.segments, most, s.smooth ? " if smooth" : "")};
        return zeroLength(s, "radius", "\"radius\" is too small");
    }
    Fault operator()(const LensShape& s) const {
        if (s.axis == Vec2(0.0)) return GeometryFault{"axis", {}, "\"axis\" is [0, 0], expected a direction"};
        for (const int k : {0, 1})
            if (s.radius[k] != 0.0 && std::abs(s.radius[k]) < s.height / 2)
                return GeometryFault{
                    "radius", static_cast<std::size_t>(k),
                    fmt::format("a surface of radius {} reaches no height of {}, expected {} or more, {} or "
                                "less, or 0 for a flat one",
                                s.radius[k], s.height, s.height / 2, -s.height / 2)};
        const double rim = rimThickness(s);
        if (hasRim(s) && rim < 0.0)
            return GeometryFault{"thickness",
                                 {},
                                 fmt::format("the surfaces cross inside the rim, expected a \"thickness\" of "
                                             "{} or more for this \"height\" and \"radius\"",
                                             s.thickness - rim)};
        if (const Fault fault = zeroLength(s, "height", "the lens is too small for where it is"))
            return fault;
        if (facetsCross(s))
            return GeometryFault{
                "segments",
                {},
                fmt::format("the surfaces' facets cross with {} segments, expected more of them or a larger "
                            "\"thickness\"",
                            s.segments)};
        return {};
    }
};

}  // namespace

std::optional<GeometryFault> findFault(const Geometry& geometry) {
    return std::visit(FaultFinder{}, geometry);
}

}  // namespace halfdisk
