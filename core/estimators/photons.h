// How bright is a wall, judged by the photons that arrived near by? Photons sorted along their walls, and a
// density estimate that divides by the kernel's length (Jensen 1996, "Global illumination using photon maps",
// brought to the plane).
#pragma once

#include "core/stop.h"
#include "core/surface.h"
#include "core/wall_chains.h"

namespace halfdisk {

/// Light that arrived at a wall.
struct Photon {
    std::uint32_t side = 0;  ///< of a chain: see sideOf
    std::uint32_t segment = 0;
    double along = 0.0;  ///< m, along the chain
    Rgb power{0.0};      ///< W
    Vec2 from{0.0};      ///< unit, back to where it came from
};

/// A place on one side of a chain of walls. The sides are apart: light on one is not on the other.
struct SidePlace {
    std::uint32_t side = 0;  ///< twice the chain, and 1 more for the back
    double along = 0.0;
};

inline SidePlace sideOf(const WallChains& chains, std::uint32_t segment, double u, bool front) {
    const ChainPlace place = chains.at(segment, u);
    return {2 * place.chain + (front ? 0 : 1), place.along};
}

/// Radius of pass p over that of pass 0: the product of (i + a) / (i + 1) over i = 1 ... p, which falls as
/// p^(a - 1); a in (0, 1], 1: it stays. One pass's variance then grows as p^(1 - a) and its bias falls as
/// p^(2 a - 2), so both vanish in the mean over all passes. (Knaus & Zwicker take this product for the square
/// of a radius: their kernel is an area.)
double shrinking(double a, std::uint64_t pass);

/// Photons of one pass. Keeps pointers to the index and the chains.
///
/// The kernel is a box: all photons within `radius` metres of arc length count alike. Where the chain ends
/// within it, or another wall touches it, it is shorter: no light is lost there, and none leaks through that
/// wall. Its expectation is exactly the mean over the kernel: off by radius^2 E'' / 6 where E is smooth, by
/// up to half its jump at an edge of light, and by its slope times radius / 2 at such an end. The variance of
/// M paths' photons is about 1 / (M radius).
class PhotonMap {
 public:
    /// Throws Stopped if `stop` says so.
    PhotonMap(const SegmentIndex& index, const WallChains& chains, std::vector<Photon> photons,
              const StopQuestion& stop = {});

    std::size_t size() const { return photons_.size(); }

    /// How many photons a kernel about `place` covers.
    std::uint32_t count(const SidePlace& place, double radius) const;

    /// W/m, that arrived about `place`.
    Rgb irradiance(const SidePlace& place, double radius) const;

    /// W/(m rad), that leaves towards `toEye` (unit) about the scattering wall's point `at`, which lies at
    /// `place`: the mean of what leaves everywhere in the kernel.
    Rgb radiance(const SurfacePoint& at, const SidePlace& place, Vec2 toEye, double radius) const;

 private:
    // Photons first ... last - 1.
    struct Run {
        std::size_t first = 0, last = 0;
    };
    // What a kernel covers: two runs where it reaches over a ring's seam.
    struct Window {
        Run runs[2];
        double length = 0.0;
    };
    Window windowAt(const SidePlace& place, double radius) const;
    Run runOf(std::uint32_t side, double from, double to) const;
    Rgb scattered(const Photon& photon, Vec2 toEye) const;

    const SegmentIndex* index_;
    const WallChains* chains_;
    std::vector<Photon> photons_;     // by side, then along it
    std::vector<double> along_;       // of each, close together for the search
    std::vector<Rgb> upTo_;           // power of the photons before each, and of all
    std::vector<std::size_t> first_;  // photon of each side, and their number
};

}  // namespace halfdisk
