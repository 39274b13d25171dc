#include "rooms.h"

namespace halfdisk::test {

std::uint32_t addWall(Scene& scene, Vec2 a, Vec2 b, Rgb albedo, Rgb emission, bool twoSided) {
    const auto index = static_cast<std::uint32_t>(scene.segments.size());
    scene.segments.push_back({a, b, static_cast<std::uint32_t>(scene.materials.size()), emission, twoSided});
    scene.segmentNames.push_back("wall " + std::to_string(index));
    scene.materialNames.push_back("material " + std::to_string(scene.materials.size()));
    scene.materials.push_back(Diffuse{albedo});
    return index;
}

Segment wallOf(Vec2 a, Vec2 b, std::uint32_t material, Rgb emission) {
    Segment wall;
    wall.a = a;
    wall.b = b;
    wall.material = material;
    wall.emission = emission;
    return wall;
}

Scene polygonRoom(const std::vector<Vec2>& points, Rgb albedo, Rgb emission) {
    Scene scene;
    scene.materials.push_back(Diffuse{albedo});
    scene.materialNames.push_back("wall");
    for (std::size_t i = 0; i < points.size(); ++i) {
        scene.segments.push_back({points[i], points[(i + 1) % points.size()], 0, emission, false});
        scene.segmentNames.push_back("wall." + std::to_string(i));
    }
    return scene;
}

Scene litBox() {
    Scene scene = polygonRoom({{-1.0, 0.0}, {1.0, 0.0}, {1.0, 1.5}, {-1.0, 1.5}}, kBoxAlbedo);
    scene.lights.emplace_back(PointLight{{0.3, 1.1}, {1.0, 0.8, 0.6}});
    return scene;
}

std::vector<Vec2> regularPolygon(int sides, double radius, Vec2 center) {
    std::vector<Vec2> points;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2.0 * kPi * k / sides;
        points.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

std::vector<Vec2> starPolygon(int spikes, double inner, double outer) {
    std::vector<Vec2> points;
    for (int k = 0; k < 2 * spikes; ++k) {
        const double angle = kPi * k / spikes;
        points.push_back((k % 2 == 0 ? outer : inner) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

std::vector<Vec2> wedge(double degrees, double turn) {
    const double angle = degrees * kPi / 180.0;
    return {{0.0, 0.0}, {std::cos(turn), std::sin(turn)}, {std::cos(turn + angle), std::sin(turn + angle)}};
}

std::vector<Vec2> moved(std::vector<Vec2> points, double scale, Vec2 offset) {
    for (Vec2& p : points) p = scale * p + offset;
    return points;
}

std::vector<Vec2> furnacePolygon() {
    return {{0.0, 0.0}, {2.0, -0.3}, {3.1, 1.0}, {2.2, 1.2}, {2.5, 2.6}, {-0.4, 1.9}};
}

Scene mixedRoom() {
    Scene scene;
    scene.environment = Rgb(0.2, 0.3, 0.4);
    addWall(scene, {-2.0, 0.0}, {2.0, 0.0}, {0.7, 0.5, 0.3});
    addWall(scene, {0.5, 2.0}, {-0.5, 2.0}, Rgb(0.2), {3.0, 2.0, 1.0});
    addWall(scene, {-1.0, 0.4}, {-0.3, 0.9}, {0.3, 0.6, 0.9}, Rgb(0.0), true);
    addWall(scene, {2.0, 0.0}, {2.0, 1.5}, Rgb(0.8), {0.1, 0.2, 0.3});
    scene.lights.emplace_back(PointLight{{1.0, 1.2}, {0.5, 0.6, 0.7}});
    scene.lights.emplace_back(DirectionalLight{{0.6, -0.8}, {0.4, 0.3, 0.2}});
    return scene;
}

}  // namespace halfdisk::test
