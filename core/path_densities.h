// How likely was a whole path, by each way of building it from both ends? What the weights of bidirectional
// tracing need.
//
// A path x_0 ... x_k runs from a light (x_0) to the sensor (x_k). Strategy s takes its first s vertices from
// the light and the rest from the sensor; its density is the product of the vertices' densities per metre,
// each given its neighbour on the side it came from (Veach 1997, section 10.2; dtheta = cos dl / r in the
// plane). A mirror or glass vertex sends in one direction with density 1: it takes part alike in all
// strategies. Of a light infinitely far away x_0 is a direction (per radian).
#pragma once

#include <span>

#include "direct_light.h"

namespace halfdisk {

/// The light's end of a path.
struct LightEnd {
    std::uint32_t light = 0;             ///< number in the LightTable
    std::uint32_t segment = kNoSegment;  ///< the lamp, if it is one
    bool infinite = false;               ///< the environment, or a directional light
    bool canBeMet = false;               ///< by a path from the sensor: a lamp or the environment
    Vec2 P{0.0};                         ///< m
    Vec2 towards{0.0};                   ///< unit, to the light, if it is infinitely far
    Vec2 N{0.0};                         ///< of the lamp's side
};

/// A wall between the ends.
struct InnerVertex {
    SurfacePoint at;
    bool delta = false;  ///< a mirror's or glass's event, in this path
};

/// How many of a pass's draws could have made the path, where that is not one.
struct StrategyCounts {
    double lightAlone = 0.0;      ///< light paths that may meet the sensor itself; 0: it can't be met
    double lightConnected = 1.0;  ///< light paths that are connected to the sensor; 0: they can't be
};

/// Looks at what it is given, and keeps nothing of it.
class WholePath {
 public:
    WholePath(const LightTable& lights, const LightEnd& light, std::span<const InnerVertex> inner,
              const Receiver& receiver, double pdfReceiver);

    /// Share of strategy s = 0 ... size() among all that could have made this path: balance or power
    /// heuristic.
    double weight(std::size_t s, const StrategyCounts& counts, Heuristic heuristic) const;

    std::size_t size() const { return inner_.size() + 2; }

 private:
    bool isDelta(std::size_t i) const { return i > 0 && i <= inner_.size() && inner_[i - 1].delta; }
    Vec2 direction(std::size_t from, std::size_t to) const;
    double perMetre(double pdfAngle, std::size_t from, std::size_t to) const;
    double fromLight(std::size_t i) const;
    double fromSensor(std::size_t i) const;
    double countOf(std::size_t s, const StrategyCounts& counts) const;

    const LightTable& lights_;
    const LightEnd& light_;
    std::span<const InnerVertex> inner_;
    const Receiver& receiver_;
    double pdfReceiver_;  // 1/m of its place, 1 if it has only one
};

}  // namespace halfdisk
