#include "shadow_edges.h"

#include <algorithm>
#include <optional>

#include "overload.h"
#include "surface.h"

namespace halfdisk {
namespace {

constexpr double kAside = 1e-7;  // of the distance: so closely rays pass a corner
constexpr double kNear = 1e-4;   // of the distance: what is met there is the corner

/// What the ray meets that passes the corner, if the one on its other side is stopped there. `way` is from
/// the origin to the corner.
std::optional<WallPlace> edgePast(const SegmentIndex& index, Vec2 origin, Vec2 way, std::uint32_t skip) {
    const Hit left = index.closestHit({origin, way + kAside * perp(way), skip}),
              right = index.closestHit({origin, way - kAside * perp(way), skip});
    const Hit &stopped = left.t < right.t ? left : right, &passing = left.t < right.t ? right : left;
    const bool isCorner = std::abs(stopped.t - 1.0) < kNear && passing.t > 1.0 + kNear;
    if (!isCorner || !passing) return std::nullopt;
    return WallPlace{passing.segment, passing.front, passing.u};
}

/// From farther away than all walls.
double reachOf(const std::vector<Vec2>& corners) {
    double reach = 0.0;
    for (const Vec2 corner : corners) reach = std::max(reach, glm::length(corner - corners.front()));
    return 2.0 * reach;
}

}  // namespace

std::vector<WallPlace> shadowEdges(const Visibility& visibility, const StopQuestion& stop) {
    const SegmentIndex& index = visibility.index();
    const double reach = reachOf(visibility.corners());
    std::vector<WallPlace> edges;
    const auto look = [&](Vec2 origin, Vec2 way, std::uint32_t skip) {
        if (const auto edge = edgePast(index, origin, way, skip)) edges.push_back(*edge);
    };
    for (const Vec2 corner : visibility.corners()) {
        throwIfStopped(stop);
        for (const DeltaLight& light : index.scene().lights)
            std::visit(Overload{[&](const PointLight& bulb) {
                                    look(bulb.position, corner - bulb.position, kNoSegment);
                                },
                                [&](const DirectionalLight& sun) {
                                    const Vec2 way = reach / glm::length(sun.direction) * sun.direction;
                                    look(corner - way, way, kNoSegment);
                                }},
                       light);
        for (const std::uint32_t lamp : index.emitters()) {
            constexpr double kEnd = 1e-6;  // of the lamp: its last light
            for (const double u : {kEnd, 1.0 - kEnd}) {
                const Vec2 end = index.pointOn(lamp, u), way = corner - end;
                const bool lights =
                    glm::dot(way, index.normal(lamp)) > 0.0 || index.scene().segments[lamp].twoSided;
                if (lights) look(originOff(index, lamp, end, way), way, lamp);
            }
        }
    }
    return edges;
}

}  // namespace halfdisk
