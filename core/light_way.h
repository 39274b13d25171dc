// Which ways does light take? The corners of paths from the lights, and what they met there.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "light_table.h"

namespace halfdisk {

/// One path of light, from where it set out to where it was absorbed, left the scene, or was followed no
/// more.
struct LightWay {
    std::vector<Vec2> corners;  ///< m; at least two
    std::string word;           ///< L, then what it met: D (diffuse or glossy) or S (mirror or glass)
    Rgb power{0.0};             ///< W, as it sets out, of one path of all
    bool escapes = false;       ///< the last corner is only somewhere outside, on its way
};

/// The first `count` paths of this seed, scattered at most so often (mirrors and glass not counted). Light
/// sets out evenly over the power of all lights. None in a dark scene.
std::vector<LightWay> lightWays(const SegmentIndex& index, std::uint32_t count, std::uint32_t scatterings,
                                std::uint64_t seed);

/// Their words, the commonest first, each with how many have it.
std::vector<std::pair<std::string, std::size_t>> countWords(const std::vector<LightWay>& ways);

/// How many of the paths come within `radius` (m) of a place on their way.
std::size_t countPassing(const std::vector<LightWay>& ways, Vec2 place, double radius);

}  // namespace halfdisk
