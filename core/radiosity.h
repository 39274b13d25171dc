// How does light spread between diffuse walls? Each is cut into patches of constant radiance, and what they
// exchange is a system of linear equations.
//
// Goral, Torrance, Greenberg & Battaile 1984, "Modeling the interaction of light between diffuse surfaces",
// in the plane: S_i = rho_i / 2 E_i + rho_i sum over j of F_ij S_j, with S the scattered radiance of a patch,
// E the light that arrives straight from point lights, directional lights and the environment, and F_ij the
// form factors; emitting patches enter the first bounce by their form factors.
#pragma once

#include <optional>
#include <span>

#include "patches.h"
#include "walk.h"

namespace halfdisk {

/// Walls must be flat and diffuse.
class Radiosity {
 public:
    /// `bounces`: light is scattered at most so often; empty: without end, by solving the system (Cholesky).
    /// Throws std::invalid_argument where that has no answer (light that is never absorbed), or if the walls
    /// take more than Patches::kMost patches; and Stopped if `stop` says so.
    Radiosity(const SegmentIndex& index, std::uint32_t patches, std::optional<std::uint32_t> bounces,
              const StopQuestion& stop = {});

    /// E (W/m): light straight from its source, exact, and what the patches scatter, exact but for their
    /// radiance being constant over each. O(n^2) of n walls.
    Rgb irradiance(const ShadedPoint& at, Counts& counts, ArcMemory& memory) const;
    Rgb irradiance(const ShadedPoint& at, Counts& counts) const;
    /// The same from all around a free point.
    Rgb fluence(Vec2 P, Counts& counts, ArcMemory& memory) const;
    Rgb fluence(Vec2 P, Counts& counts) const;

    const Patches& patches() const { return patches_; }
    /// Scattered radiance (W/(m rad)) of each patch.
    std::span<const Rgb> scattered() const { return scattered_; }

 private:
    template <class Measure>
    Rgb gather(const ShadedPoint& at, const Measure& measure, Counts& counts, ArcMemory& memory) const;

    const SegmentIndex& index() const { return visibility_.index(); }

    Visibility visibility_;
    Patches patches_;
    std::vector<Rgb> scattered_;
};

}  // namespace halfdisk
