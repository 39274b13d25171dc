// Which light is asked, and where does light set out from? Lights are chosen in proportion to their power.
//
// Numbers of lights: first scene.lights, then the emitting segments (as in light.h), last the environment,
// which counts as a light if it is not black.
#pragma once

#include "cover.h"
#include "surface.h"

namespace halfdisk {

struct LightPick {
    std::uint32_t light = 0;
    double probability = 0.0;  ///< 0: the scene has no light
    double within = 0.5;       ///< what is left of the number drawn: uniform in (0, 1)
};

/// Light as it sets out: the first vertex of a path that is traced forward.
struct Emission {
    Ray ray;
    Rgb power{0.0};  ///< W, divided by all that was drawn: its mean is the scene's whole power
    std::uint32_t light = 0;
    Vec2 N{0.0};                         ///< side of the emitting segment that it leaves; zero for others
    std::uint32_t segment = kNoSegment;  ///< the emitting segment
    double pdfPosition =
        0.0;  ///< 1/m: along the segment, or across a beam from infinitely far; 0: a point light's
    double pdfAngle = 0.0;  ///< 1/rad, of the direction; 0: a directional light's
};

/// Made once per scene. Keeps a pointer to the index.
class LightTable {
 public:
    /// `extra` are points that light from infinitely far away must reach besides the walls: corners of a
    /// field, an eye.
    explicit LightTable(const SegmentIndex& index, const std::vector<Vec2>& extra = {});

    const SegmentIndex& index() const { return *index_; }
    bool isDark() const { return total_ == 0.0; }
    std::uint32_t environmentLight() const { return count_; }

    /// Circle (m) that holds everything: light from infinitely far away sets out from a tangent to it.
    Vec2 center() const { return center_; }
    double radius() const { return radius_; }

    /// The number of an emitting segment.
    std::uint32_t lightOf(std::uint32_t segment) const;

    LightPick pick(double u) const;
    double probability(std::uint32_t light) const;
    Rgb power(std::uint32_t light) const {
        return powers_[light];
    }  ///< W; of light from infinitely far: into the circle

    /// Draws a way from P to a light, as sampleLight does, the environment included. u in (0, 1).
    LightSample sampleFrom(std::uint32_t light, Vec2 P, double u) const;

    /// Density (1/rad) with which pick and sampleFrom together draw the direction of a ray that met a lamp,
    /// or no wall.
    double pdfDrawn(const Ray& ray, const Hit& hit) const;

    /// Density (1/rad) of sampleFrom for the environment alone.
    double pdfEnvironment(Vec2 direction) const;

    /// Light that sets out. `place` in (0, 1) runs over all the power of all lights: which one, and where on
    /// it (or across its beam; of a point light, whither). `v` in (0, 1) is the direction. Power is 0 where a
    /// lamp is covered (cover.h), and from a point light on a wall into that wall: none of it gets out.
    Emission emit(double place, double v) const;

    /// Density (1/m or 1/rad) of emit's draws, given the light: along a lamp, or across a beam.
    double pdfPositionOf(std::uint32_t light) const;

 private:
    Vec2 drawEnvironment(double u) const;
    Ray beam(Vec2 direction, double u) const;

    const SegmentIndex* index_;
    void leaveWall(std::uint32_t wall, Emission& light) const;

    std::vector<std::uint32_t> onWall_;  // of scene.lights: the wall that a point light lies on
    CoveredWalls covers_;                // of lamps
    std::uint32_t count_;                // of lights without the environment
    Vec2 center_{0.0};
    double radius_ = 0.0;
    std::vector<Rgb> powers_;
    std::vector<double> upTo_;     // running sums of the powers' channel means
    std::vector<double> skyUpTo_;  // running sums of the environment's strip
    double total_ = 0.0;
};

}  // namespace halfdisk
