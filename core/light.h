// From where does a light send how much to P? Point and directional lights have one direction; on an emitting
// segment a point is drawn.
#pragma once

#include "intersect.h"

namespace halfdisk {

/// One way from P to a light.
struct LightSample {
    Vec2 L{0.0};                         ///< unit, from P to the light
    double distance = kInfinity;         ///< m
    Rgb L_i{0.0};                        ///< irradiance on a surface that faces it, divided by the pdf: W / m
    std::uint32_t segment = kNoSegment;  ///< the emitting segment, if it is one
    double pdfAngle = 0.0;  ///< 1 / rad, of L as seen from P; 0 for a light with one direction only
};

/// Lights are numbered: first scene.lights, then the emitting segments.
std::uint32_t lightCount(const SegmentIndex& index);
bool isDelta(const SegmentIndex& index, std::uint32_t light);
bool isPoint(const SegmentIndex& index, std::uint32_t light);

/// Draws a way from P to `light`; u in (0, 1) picks the point on an emitting segment.
/// Point: L_i = I / r. Directional: L_i = E0. Segment: L_i = Le / pdfAngle, where pdfAngle = r / (length
/// cos') comes from the uniform pdfLength = 1 / length by dtheta = cos' dl / r. L_i is 0 where the segment
/// turns its dark back.
LightSample sampleLight(const SegmentIndex& index, std::uint32_t light, Vec2 P, double u);

/// pdfAngle with which sampleLight draws the direction of a ray that hit an emitting segment: r / (length
/// cos').
double pdfLight(const SegmentIndex& index, const Ray& ray, const Hit& hit);

}  // namespace halfdisk
