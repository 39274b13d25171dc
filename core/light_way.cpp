#include "light_way.h"

#include <algorithm>
#include <map>

#include "estimators/light_paths.h"

namespace halfdisk {
namespace {

/// Writes one path after the other down.
struct Scribe : WalkVisitor {
    double beyond;  // m: how far a path that escapes is drawn
    std::vector<LightWay> ways;

    void fly(const Ray& ray, double distance, const Rgb& throughput, std::uint32_t) {
        if (isNew) ways.push_back({{ray.origin}, "L", throughput, false});
        isNew = false;
        ways.back().escapes = distance == kInfinity;
        ways.back().corners.push_back(ray.origin + std::min(distance, beyond) * ray.direction);
    }
    bool arrive(const Arrival& here) {
        ways.back().word += isSpecular(*here.at.material) ? 'S' : 'D';
        return true;
    }
    void depart(const Arrival&, const Scattered& way) {
        if (way.isDelta()) ways.back().word.back() = 'S';  // of a mix, the part that was followed
    }

    bool isNew = true;
};

bool passes(Vec2 a, Vec2 b, Vec2 place, double radius) {
    const Vec2 edge = b - a;
    const double length2 = glm::dot(edge, edge);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(place - a, edge) / length2, 0.0, 1.0) : 0.0;
    return glm::length(a + t * edge - place) <= radius;
}

}  // namespace

std::vector<LightWay> lightWays(const SegmentIndex& index, std::uint32_t count, std::uint32_t scatterings,
                                std::uint64_t seed) {
    const LightTable lights(index);
    if (lights.isDark()) return {};
    Scribe scribe;
    scribe.beyond = 4.0 * lights.radius();
    const Rng ofPaths = Rng(seed, 0).child(kLightPathsChild);
    WalkLimits limits;
    limits.scatterings = scatterings;
    Counts counts;
    for (std::uint32_t path = 0; path < count; ++path) {
        const Rng rng = ofPaths.child(path);
        // Evenly, but in an order in which the first few are spread as well (van der Corput).
        double place = 0.0;
        for (std::uint32_t bits = path + 1, k = 1; bits != 0; bits >>= 1, ++k)
            place += (bits & 1u) * std::ldexp(1.0, -static_cast<int>(k));
        const Emission light = lights.emit(place, rng.uniform(draws::kStart, 1));
        if (light.power == Rgb(0.0)) continue;
        scribe.isNew = true;
        walk(index, light.ray, light.power, Carried::power, limits, rng, counts, scribe);
    }
    return std::move(scribe.ways);
}

std::vector<std::pair<std::string, std::size_t>> countWords(const std::vector<LightWay>& ways) {
    std::map<std::string, std::size_t> counts;
    for (const LightWay& way : ways) ++counts[way.word];
    std::vector<std::pair<std::string, std::size_t>> words(counts.begin(), counts.end());
    std::stable_sort(words.begin(), words.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    return words;
}

std::size_t countPassing(const std::vector<LightWay>& ways, Vec2 place, double radius) {
    std::size_t count = 0;
    for (const LightWay& way : ways)
        for (std::size_t i = 1; i < way.corners.size(); ++i)
            if (passes(way.corners[i - 1], way.corners[i], place, radius)) {
                ++count;
                break;
            }
    return count;
}

}  // namespace halfdisk
