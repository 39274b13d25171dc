// Are the hits right that the benchmark counts? Every wall is asked, in double precision, by code of its own.
#pragma once

#include <span>

#include "peers.h"

namespace halfdisk {

/// The first wall at t > 0 whose endpoints lie on different sides of the ray (zero counts as positive).
Hit bruteClosest(const Scene& scene, const Ray& ray);

/// Whether a wall is met at 0 < t < tMax.
bool bruteOccluded(const Scene& scene, const Ray& ray, double tMax);

/// Rays on which a hit is another wall or side than the brute check's, or t is off by more than `tolerance`
/// m.
std::size_t countDifferences(std::span<const Hit> hits, std::span<const Hit> brute, double tolerance);

/// The same of single precision: whether something is met at all, and t. A wall beside the vertex that it
/// shares may stand in for it.
std::size_t countDifferences(std::span<const PeerHit> hits, std::span<const Hit> brute, double tolerance);

std::size_t countDifferences(std::span<const std::uint8_t> answers, std::span<const std::uint8_t> brute);

}  // namespace halfdisk
