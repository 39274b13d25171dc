// Which known programs are asked for the same hits? Optional: where one is not installed, it is not asked.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "workloads.h"

namespace halfdisk {

/// A ray as the peers take it: in single precision, unit direction.
struct FloatRay {
    float x, y, dx, dy;
    float tMax;
};

std::vector<FloatRay> floatRays(std::span<const Ray> rays, std::span<const double> tMax = {});

/// What a peer finds.
struct PeerHit {
    std::uint32_t segment;  ///< kNoSegment: none
    float t;
};

/// A scene made ready for rays, by someone else.
class Peer {
 public:
    virtual ~Peer() = default;
    virtual void closest(std::span<const FloatRay> rays, std::span<PeerHit> hits) const = 0;
    virtual void occluded(std::span<const FloatRay> rays, std::span<std::uint8_t> answers) const = 0;
    /// Sixteen rays at a time; the count is a multiple of 16.
    virtual void closestPackets(std::span<const FloatRay>, std::span<PeerHit>) const {}
    virtual double buildSeconds() const = 0;      ///< CPU time
    virtual double bytes() const { return 0.0; }  ///< of the structure; 0: not known
};

/// How a segment becomes triangles for Embree: both have the segment as their cut with z = 0.
enum class Extrusion : std::uint8_t {
    twoTriangles,  ///< of a rectangle, z = -1 ... 1
    oneTriangle,   ///< with its tip far below and its upper side just above z = 0: hardly wider than the
                   ///< segment
};

/// Embree 3, one thread, medium build quality. Null if it is not installed.
std::unique_ptr<Peer> makeEmbree(const Scene& scene, Extrusion extrusion);

/// Box2D 2.4: static edges, the world scaled by 1000. Null if it is not installed.
std::unique_ptr<Peer> makeBox2D(const Scene& scene);

/// A message for each peer that is not installed.
std::vector<std::string> missingPeers();

}  // namespace halfdisk
