// Which walls does a shape consist of, where do they meet, and what are they called?
#include "lessons/scene_expansion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "lessons/input_error.h"

namespace halfdisk {
namespace {

/// `v` turned by `quarters` right angles, without rounding.
Vec2 turnedByQuarters(Vec2 v, std::uint64_t quarters) {
    switch (quarters % 4) {
        case 1:
            return {-v.y, v.x};
        case 2:
            return {-v.x, -v.y};
        case 3:
            return {v.y, -v.x};
        default:
            return v;
    }
}

/// Walls along a chain of vertices; the last one ends at the first vertex if `closed`.
std::vector<Edge> chain(const std::vector<Vec2>& vertices, bool closed, bool reversed) {
    std::vector<Edge> edges;
    const std::size_t count = closed ? vertices.size() : vertices.size() - 1;
    edges.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2 start = vertices[k];
        const Vec2 end = vertices[(k + 1) % vertices.size()];
        edges.push_back(reversed ? Edge{end, start} : Edge{start, end});
    }
    return edges;
}

bool isFullTurn(const ArcShape& arc) {
    return std::abs(arc.to - arc.from) >= 360.0 - (kMaxSweep - 360.0);
}

struct EdgeCounter {
    std::uint64_t operator()(const SegmentShape&) const { return 1; }
    std::uint64_t operator()(const PolylineShape& s) const {
        return s.points.empty() ? 0 : s.points.size() - 1;
    }
    std::uint64_t operator()(const PolygonShape& s) const { return s.points.size(); }
    std::uint64_t operator()(const BoxShape&) const { return 4; }
    std::uint64_t operator()(const CircleShape& s) const { return s.segments; }
    std::uint64_t operator()(const ArcShape& s) const { return s.segments; }
};

struct EdgeMaker {
    std::vector<Edge> operator()(const SegmentShape& s) const { return {{s.a, s.b}}; }
    std::vector<Edge> operator()(const PolylineShape& s) const {
        return s.points.empty() ? std::vector<Edge>{} : chain(s.points, false, false);
    }
    std::vector<Edge> operator()(const PolygonShape& s) const { return chain(s.points, true, false); }
    std::vector<Edge> operator()(const BoxShape& s) const {
        return chain({s.min, {s.max.x, s.min.y}, s.max, {s.min.x, s.max.y}}, true, s.facing == Facing::out);
    }
    std::vector<Edge> operator()(const CircleShape& s) const {
        std::vector<Vec2> vertices;
        vertices.reserve(s.segments);
        for (std::uint32_t k = 0; k < s.segments; ++k)
            vertices.push_back(s.center + s.radius * unitAtFraction(k, s.segments));
        // Counter-clockwise, so the left of k -> k + 1 is the inside.
        return chain(vertices, true, s.facing == Facing::out);
    }
    std::vector<Edge> operator()(const ArcShape& s) const {
        const bool full = isFullTurn(s);
        const double sweep = s.to - s.from;
        std::vector<Vec2> vertices;
        vertices.reserve(s.segments + std::size_t{1});
        for (std::uint32_t k = 0; k < s.segments; ++k)
            vertices.push_back(s.center + s.radius * unitAtDegrees(s.from + sweep * k / s.segments));
        if (!full) vertices.push_back(s.center + s.radius * unitAtDegrees(s.to));
        const bool leftIsInside = sweep > 0.0;
        return chain(vertices, full, (s.facing == Facing::in) != leftIsInside);
    }
};

DeltaLight withUnitDirection(DeltaLight light) {
    if (auto* directional = std::get_if<DirectionalLight>(&light)) {
        // Scaled first, so that squares neither overflow nor vanish.
        const Vec2 d = directional->direction;
        directional->direction = glm::normalize(d / std::max(std::abs(d.x), std::abs(d.y)));
    }
    return light;
}

}  // namespace

Vec2 unitAtFraction(std::uint32_t k, std::uint32_t count) {
    const std::uint64_t quarterTurns = std::uint64_t{4} * k;
    const std::uint64_t rest = quarterTurns % count;  // angle within its quarter: pi / 2 * rest / count
    const auto angle = [&](std::uint64_t part) {
        return kPi / 2 * static_cast<double>(part) / static_cast<double>(count);
    };
    Vec2 unit;
    if (2 * rest == count) {
        unit = Vec2(std::sqrt(0.5));
    } else if (2 * rest < count) {
        unit = {std::cos(angle(rest)), std::sin(angle(rest))};
    } else {
        unit = {std::sin(angle(count - rest)), std::cos(angle(count - rest))};
    }
    return turnedByQuarters(unit, quarterTurns / count);
}

Vec2 unitAtDegrees(double degrees) {
    double positive = std::fmod(degrees, 360.0);
    if (positive < 0.0) positive += 360.0;
    const double quarters = std::floor(positive / 90.0);
    const double rest = (positive - 90.0 * quarters) * (kPi / 180.0);
    return turnedByQuarters({std::cos(rest), std::sin(rest)}, static_cast<std::uint64_t>(quarters));
}

bool isZeroLength(Vec2 a, Vec2 b) {
    // Each coordinate carries a rounding error of up to 1.1e-16 of its size: a length below some 50 of those
    // has a direction that is wrong by degrees. The absolute bound keeps the square of the length above
    // underflow.
    constexpr double kRelative = 5e-15;
    constexpr double kAbsolute = 1e-100;
    const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return !(length > std::max(kAbsolute, kRelative * size));
}

std::uint64_t edgeCount(const Geometry& geometry) {
    return std::visit(EdgeCounter{}, geometry);
}

std::vector<Edge> edgesOf(const Geometry& geometry) {
    return std::visit(EdgeMaker{}, geometry);
}

std::vector<std::string> shapeNames(const std::vector<Shape>& shapes) {
    // "box1" is taken by a wall "box1.0" too: it would be the name of the made-up box's first edge.
    std::unordered_set<std::string> taken;
    for (const Shape& shape : shapes) {
        taken.insert(shape.name);
        taken.insert(shape.name.substr(0, shape.name.rfind('.')));
    }
    std::array<std::uint64_t, kShapeKinds.size()> counts{};
    std::vector<std::string> names;
    names.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        std::string name = shape.name;
        const std::size_t kind = shape.geometry.index();
        while (name.empty() || (shape.name.empty() && taken.count(name) > 0))
            name = fmt::format("{}{}", kShapeKinds[kind], ++counts[kind]);
        names.push_back(std::move(name));
    }
    return names;
}

Scene expandScene(const SceneDescription& description) {
    Scene scene;
    scene.title = description.title;
    scene.environment = description.environment;
    std::unordered_map<std::string_view, std::uint32_t> materialIndex;
    const auto addMaterial = [&](std::string_view name, const Material& material) {
        materialIndex.emplace(name, static_cast<std::uint32_t>(scene.materials.size()));
        scene.materialNames.emplace_back(name);
        scene.materials.push_back(material);
    };
    for (const NamedMaterial& named : description.materials) addMaterial(named.name, named.material);
    const auto materialOf = [&](const Shape& shape) {
        const std::string_view name =
            shape.material.empty() ? kDefaultMaterial : std::string_view(shape.material);
        if (name == kDefaultMaterial && materialIndex.count(name) == 0)
            addMaterial(kDefaultMaterial, Diffuse{});
        const auto found = materialIndex.find(name);
        if (found == materialIndex.end()) throw InputError(fmt::format("there is no material \"{}\"", name));
        return found->second;
    };

    const std::vector<std::string> names = shapeNames(description.shapes);
    for (std::size_t i = 0; i < description.shapes.size(); ++i) {
        const Shape& shape = description.shapes[i];
        const std::uint32_t material = materialOf(shape);
        const bool single = std::holds_alternative<SegmentShape>(shape.geometry);
        std::size_t number = 0;
        for (const Edge& edge : edgesOf(shape.geometry)) {
            scene.segments.push_back({edge.a, edge.b, material, shape.emission, shape.twoSided});
            scene.segmentNames.push_back(single ? names[i] : fmt::format("{}.{}", names[i], number++));
        }
    }
    for (const DeltaLight& light : description.lights) scene.lights.push_back(withUnitDirection(light));
    return scene;
}

}  // namespace halfdisk
