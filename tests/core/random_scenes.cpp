#include "random_scenes.h"

#include "rooms.h"
#include "support.h"

namespace halfdisk::test {
namespace {

class Builder {
 public:
    explicit Builder(std::uint64_t seed) : random_(seed) {}

    Scene build() {
        const bool closed = chance(0.5);
        const double w = random_.in(2.0, 3.5), h = random_.in(1.5, 2.5);
        addWall({0.0, 0.0}, {w, 0.0}, matt());
        if (closed || chance(0.6)) addWall({w, 0.0}, {w, h}, any());
        const bool ceiling = closed || chance(0.3);
        if (closed || chance(0.6)) addWall({0.0, h}, {0.0, 0.0}, any());
        if (ceiling) addWall({w, h}, {0.0, h}, any());
        const bool lamp = chance(0.6), point = chance(0.35), sun = !closed && chance(0.4),
                   sky = !closed && chance(0.4);
        if (lamp || !(point || sun || sky)) {
            const double at = random_.in(0.3, w - 0.9), length = random_.in(0.05, 0.6),
                         drop = random_.in(0.05, 0.3);
            addWall({at + length, h - drop}, {at, h - drop}, matt(), colour(0.5, 4.0));
        }
        if (point)
            scene_.lights.emplace_back(
                PointLight{{random_.in(0.3, w - 0.3), random_.in(0.9 * h, 0.95 * h)}, colour(0.3, 2.0)});
        if (sun) {
            const double turn = random_.in(-0.7, 0.7);
            scene_.lights.emplace_back(DirectionalLight{{std::sin(turn), -std::cos(turn)}, colour(0.3, 2.0)});
        }
        if (sky) {
            scene_.environment = Environment(colour(0.05, 0.5));
            if (chance(0.5))
                for (int k = 0; k < 8; ++k) scene_.environment.strip.push_back(colour(0.1, 2.0));
        }
        addThing(w, h);
        return scene_;
    }

 private:
    bool chance(double p) { return random_.in(0.0, 1.0) < p; }
    Rgb colour(double least, double most) {
        const bool grey = chance(0.5);
        const double value = random_.in(least, most);
        if (grey) return Rgb(value);
        const double green = random_.in(least, most);
        return {value, green, random_.in(least, most)};
    }
    Material matt() { return Diffuse{colour(0.05, 0.7)}; }
    Material any() {
        const double kind = random_.in(0.0, 1.0);
        if (kind < 0.65) return matt();
        if (kind < 0.8) return Mirror{colour(0.4, 0.95)};
        const Glossy lobe{colour(0.3, 0.7), random_.in(2.0, 40.0)};
        if (kind < 0.9) return lobe;
        Mix mix{Diffuse{colour(0.1, 0.7)}, lobe, random_.in(0.2, 0.7)};
        if (chance(0.5)) mix.specular = Mirror{colour(0.4, 0.9)};
        return mix;
    }

    void addWall(Vec2 a, Vec2 b, const Material& material, Rgb emission = Rgb(0.0)) {
        scene_.segments.push_back(
            wallOf(a, b, static_cast<std::uint32_t>(scene_.materials.size()), emission));
        scene_.segmentNames.push_back("wall " + std::to_string(scene_.segments.size()));
        scene_.materialNames.push_back("material " + std::to_string(scene_.materials.size()));
        scene_.materials.push_back(material);
    }

    // In the middle: nothing, a glass disk, or a block of any material.
    void addThing(double w, double h) {
        const double kind = random_.in(0.0, 1.0);
        if (kind < 0.3) return;
        const Vec2 middle{random_.in(0.35 * w, 0.65 * w), random_.in(0.4 * h, 0.55 * h)};
        const bool glass = kind < 0.65;
        const auto sides = glass ? static_cast<int>(random_.integer(16, 40)) : 4;
        const double radius = random_.in(0.15, 0.3);
        const Material material =
            glass ? Material(Dielectric{random_.in(1.2, 1.8), chance(0.3) ? colour(0.1, 1.0) : Rgb(0.0)})
                  : any();
        const bool smooth = glass && chance(0.5);
        const std::vector<Vec2> points = regularPolygon(sides, radius, middle);
        const auto number = static_cast<std::uint32_t>(scene_.materials.size());
        scene_.materialNames.push_back("thing");
        scene_.materials.push_back(material);
        for (std::size_t k = 0; k < points.size(); ++k) {
            // Clockwise: its front is outside.
            const Vec2 a = points[(k + 1) % points.size()], b = points[k];
            Segment skin = wallOf(a, b, number);
            if (smooth) {
                skin.normalA = glm::normalize(a - middle);
                skin.normalB = glm::normalize(b - middle);
            }
            scene_.segments.push_back(skin);
            scene_.segmentNames.push_back("thing." + std::to_string(k));
        }
    }

    Random random_;
    Scene scene_;
};

}  // namespace

Scene randomScene(std::uint64_t seed) {
    return Builder(seed).build();
}

}  // namespace halfdisk::test
