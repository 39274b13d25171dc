#include "workloads.h"

#include <array>
#include <random>

namespace halfdisk {
namespace {

struct Box {
    Vec2 min, max;
};

constexpr Box kUnitBox{Vec2(0.0), Vec2(1.0)};

Box boundsOf(const Scene& scene) {
    Box box{Vec2(kInfinity), Vec2(-kInfinity)};
    for (const Segment& s : scene.segments)
        box = {glm::min(box.min, glm::min(s.a, s.b)), glm::max(box.max, glm::max(s.a, s.b))};
    return box;
}

/// Uniform numbers that are the same with every compiler.
class Uniform {
 public:
    explicit Uniform(std::uint64_t seed) : engine_(seed) {}
    double in(double from, double to) {
        return from + (to - from) * ((static_cast<double>(engine_() >> 12) + 0.5) * 0x1p-52);
    }
    Vec2 in(const Box& box) {
        const double x = in(box.min.x, box.max.x);
        return {x, in(box.min.y, box.max.y)};
    }
    Vec2 direction() {
        const double angle = in(0.0, 2.0 * kPi);
        return {std::cos(angle), std::sin(angle)};
    }

 private:
    std::mt19937_64 engine_;
};

bool isInBox(Vec2 p) {
    return p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0;
}

void addLoop(Scene& scene, const std::vector<Vec2>& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        scene.segments.push_back({points[i], points[(i + 1) % points.size()]});
}

/// Lengths of 0.5 ... 1.5 / sqrt(count): a ray flies about pi / 2 mean lengths before it meets a wall.
void addRandom(Scene& scene, std::size_t count) {
    Uniform uniform(1);
    while (scene.segments.size() < count) {
        const Vec2 middle = uniform.in(kUnitBox);
        const Vec2 half = uniform.direction() * (0.5 * uniform.in(0.5, 1.5) / std::sqrt(count));
        if (isInBox(middle - half) && isInBox(middle + half))
            scene.segments.push_back({middle - half, middle + half});
    }
}

/// Circles of 64 walls (one of 16 if there are no more) at random places; radii 0.05 ... 0.5 / sqrt(circles),
/// evenly in their logarithm, so that walls come in many sizes.
void addCircles(Scene& scene, std::size_t count) {
    Uniform uniform(2);
    const std::size_t sides = std::min<std::size_t>(count, 64), circles = (count + sides / 2) / sides;
    while (scene.segments.size() < circles * sides) {
        const double radius = 0.5 * std::pow(10.0, uniform.in(-1.0, 0.0)) / std::sqrt(circles);
        const Vec2 center = uniform.in(kUnitBox);
        if (!isInBox(center - radius) || !isInBox(center + radius)) continue;
        std::vector<Vec2> points;
        for (std::size_t k = 0; k < sides; ++k) {
            const double angle = -2.0 * kPi * static_cast<double>(k) / static_cast<double>(sides);
            points.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
        }
        addLoop(scene, points);
    }
}

/// Koch's curve on the four sides of a square, outwards: one closed room of 4^(levels + 1) walls.
void addFractal(Scene& scene, std::size_t count) {
    // The peaks of the first level stand 1 / (2 sqrt(3)) of a side outside the square.
    const double low = 0.1830127018922193, high = 1.0 - low;
    std::vector<Vec2> points = {{low, low}, {high, low}, {high, high}, {low, high}};
    while (points.size() * 2 < count) {
        std::vector<Vec2> finer;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 a = points[i], e = (points[(i + 1) % points.size()] - a) / 3.0;
            const Vec2 peak = a + 1.5 * e - perp(e) * (0.5 * std::numbers::sqrt3);
            finer.insert(finer.end(), {a, a + e, peak, a + 2.0 * e});
        }
        points = std::move(finer);
    }
    addLoop(scene, points);
}

constexpr std::array<PatternInfo, 3> kPatterns{{
    {Pattern::random, "random", "segments of 0.5 ... 1.5 / sqrt(n) at random in the unit box", false},
    {Pattern::circles, "circles", "circles of 64 segments, radii 0.05 ... 0.5 / sqrt(circles)", true},
    {Pattern::fractal, "fractal", "one closed Koch island", true},
}};

}  // namespace

const PatternInfo& infoOf(Pattern pattern) {
    return kPatterns[static_cast<std::size_t>(pattern)];
}

Scene makePattern(Pattern pattern, std::size_t count) {
    Scene scene;
    scene.materials.emplace_back(Diffuse{});
    scene.materialNames.emplace_back("wall");
    if (pattern == Pattern::random) addRandom(scene, count);
    if (pattern == Pattern::circles) addCircles(scene, count);
    if (pattern == Pattern::fractal) addFractal(scene, count);
    for (std::size_t i = 0; i < scene.segments.size(); ++i) scene.segmentNames.push_back(std::to_string(i));
    return scene;
}

std::vector<Ray> incoherentRays(const Scene& scene, std::size_t count) {
    Uniform uniform(3);
    const Box box = boundsOf(scene);
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        ray.origin = uniform.in(box);
        ray.direction = uniform.direction();
    }
    return rays;
}

std::vector<Ray> pointPairs(const Scene& scene, std::size_t count, std::vector<double>& tMax) {
    Uniform uniform(4);
    const Box box = boundsOf(scene);
    std::vector<Ray> rays(count);
    tMax.clear();
    for (Ray& ray : rays) {
        ray.origin = uniform.in(box);
        const Vec2 way = uniform.in(box)-ray.origin;
        tMax.push_back(glm::length(way));
        ray.direction = way / tMax.back();
    }
    return rays;
}

std::vector<Ray> halfDiskFans(const Scene& scene, std::size_t fans) {
    Uniform uniform(5);
    const Box box = boundsOf(scene);
    std::vector<Ray> rays;
    for (std::size_t fan = 0; fan < fans; ++fan) {
        const Vec2 origin = uniform.in(box);
        const Frame frame = frameFromNormal(uniform.direction());
        for (std::size_t k = 0; k < kFanRays; ++k) {
            const double theta = kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(kFanRays);
            rays.push_back({origin, frame.toWorld(std::cos(theta), std::sin(theta))});
        }
    }
    return rays;
}

}  // namespace halfdisk
