// Does a scene that is written and read again stay equal, bit for bit?
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

/// The issue's own example, with every kind of shape added.
constexpr std::string_view kEverything = R"(
title = "Corner \"α\" \\"
environment = { radiance = [0.1, 0.2, 0.30000000000000004] }

[material.white]
type = "diffuse"
albedo = [0.8, 0.8, 0.8]

[material."Grün, hell"]
albedo = [0.1, 0.5, 1]

[[segment]]
name = "floor"
a = [0.0, 0.0]
b = [2.0, 0.0]
material = "white"
emission = 0.0          # radiance, W/(m rad), leaving the front
twoSided = false

[[polygon]]
name = "block"
points = [[0.5, 0.2], [0.5, 0.6], [0.9, 0.6], [0.9, 0.2]]
material = "white"

[[segment]]
a = [-1, -1e-300]
b = [1e9, 5e-324]
material = "Grün, hell"
emission = [1e-9, 3, 1e30]
twoSided = true

[[polyline]]
name = "path"
points = [[0, 0], [0.1, 0], [0.2, 0.30000000000000004], [1e-7, 1e8], [123456.789, -0.0], [3, 4], [5, 6], [7, 8], [9, 10]]

[[box]]
min = [-1, -2]
max = [3, 4]
facing = "in"

[[circle]]
center = [1, 2]
radius = 0.5
segments = 7

[[arc]]
center = [0, 0]
radius = 2
from = 90
to = -45.5
segments = 3
facing = "in"

[[light]]
type = "point"
position = [1.0, 1.5]
intensity = 1.0

[[light]]
type = "directional"
direction = [0.0, -3.0]
irradiance = [1.0, 0.5, 0.25]

[eye]
position = [1, 2]
direction = [-3, 0.1]
fov = 60.1
)";

void checkRoundTrip(const SceneDescription& scene) {
    const std::string text = writeScene(scene);
    CAPTURE(text);
    const SceneDescription again = parseScene(text, "written.toml");
    CHECK(again == scene);
    CHECK(writeScene(again) == text);
}

}  // namespace

TEST_CASE("a scene of every kind is read as it stands") {
    const SceneDescription scene = parseScene(kEverything, "x.toml");
    CHECK(scene.title == "Corner \"\u03b1\" \\");
    CHECK(scene.environment == Sky{Rgb(0.1, 0.2, 0.30000000000000004), ""});
    REQUIRE(scene.materials.size() == 2);
    CHECK(scene.materials[0] == NamedMaterial{"white", Diffuse{Rgb(0.8)}});
    CHECK(scene.materials[1] == NamedMaterial{"Gr\u00fcn, hell", Diffuse{Rgb(0.1, 0.5, 1.0)}});
    REQUIRE(scene.shapes.size() == 7);
    // In file order, although the parser sorts by name.
    const char* kinds[] = {"segment", "polygon", "segment", "polyline", "box", "circle", "arc"};
    for (std::size_t i = 0; i < 7; ++i) CHECK(kShapeKinds[scene.shapes[i].geometry.index()] == kinds[i]);
    CHECK(scene.shapes[0] == Shape{"floor", SegmentShape{{0, 0}, {2, 0}}, "white", Rgb(0.0), false});
    CHECK(scene.shapes[2] ==
          Shape{"", SegmentShape{{-1, -1e-300}, {1e9, 5e-324}}, "Gr\u00fcn, hell", Rgb(1e-9, 3, 1e30), true});
    CHECK(scene.shapes[4].geometry == Geometry(BoxShape{{-1, -2}, {3, 4}, Facing::in}));
    CHECK(scene.shapes[5].geometry == Geometry(CircleShape{{1, 2}, 0.5, 7, Facing::out}));
    CHECK(scene.shapes[6].geometry == Geometry(ArcShape{{0, 0}, 2, 90, -45.5, 3, Facing::in}));
    REQUIRE(scene.lights.size() == 2);
    CHECK(scene.lights[0] == DeltaLight(PointLight{{1, 1.5}, Rgb(1.0)}));
    CHECK(scene.lights[1] == DeltaLight(DirectionalLight{{0, -3}, Rgb(1, 0.5, 0.25)}));
    CHECK(scene.eye == EyeDescription{{1, 2}, {-3, 0.1}, 60.1});
}

TEST_CASE("every kind of shape survives writing and reading") {
    const SceneDescription scene = parseScene(kEverything, "x.toml");
    checkRoundTrip(scene);
    for (const Shape& shape : scene.shapes) {
        SceneDescription alone;
        alone.materials = scene.materials;
        alone.shapes = {shape};
        checkRoundTrip(alone);
    }
    CHECK(expandScene(parseScene(writeScene(scene), "y")) == expandScene(scene));
}

TEST_CASE("what is at its default is not written, and made-up names are not either") {
    CHECK(writeScene({}).empty());
    checkRoundTrip({});
    SceneDescription scene;
    scene.shapes.push_back({"", BoxShape{{0, 0}, {1, 2}, Facing::out}, "", Rgb(0.0), false});
    CHECK(writeScene(scene) == "[[box]]\nmin = [0.0, 0.0]\nmax = [1.0, 2.0]\n");
    scene.environment.light = Rgb(0.5);
    CHECK(writeScene(scene) ==
          "environment = { radiance = 0.5 }\n\n[[box]]\nmin = [0.0, 0.0]\nmax = [1.0, 2.0]\n");
}

TEST_CASE("any finite number keeps every bit") {
    std::mt19937_64 random(7);
    SceneDescription scene;
    PolylineShape line;
    while (line.points.size() < 2000) {
        double xy[2];
        for (double& value : xy) {
            do {
                const std::uint64_t bits = random();
                std::memcpy(&value, &bits, sizeof value);
            } while (!(std::abs(value) <= 1e9));
        }
        const Vec2 point(xy[0], xy[1]);
        if (line.points.empty() || !isZeroLength(line.points.back(), point)) line.points.push_back(point);
    }
    scene.shapes.push_back({"line", line, "", Rgb(0.0), false});
    const auto again = parseScene(writeScene(scene), "x");
    const auto& points = std::get<PolylineShape>(again.shapes.at(0).geometry).points;
    REQUIRE(points.size() == line.points.size());
    CHECK(std::memcmp(points.data(), line.points.data(), points.size() * sizeof(Vec2)) == 0);
}

TEST_CASE("long lists of points stay within the line, and names are quoted where they must be") {
    SceneDescription scene;
    PolylineShape line;
    for (int i = 0; i < 100; ++i) line.points.emplace_back(i, 0.1 * i);
    scene.materials.push_back({"with \"quotes\" and . dots", Diffuse{Rgb(0.25)}});
    scene.shapes.push_back({"a 'name' = [x] # \\", line, "with \"quotes\" and . dots", Rgb(0.0), false});
    checkRoundTrip(scene);
    const std::string text = writeScene(scene);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        CHECK(end - at <= 110);
        at = end + 1;
    }
}

namespace {

/// Scenes of every kind of thing, with any values that are allowed.
struct RandomScene {
    std::mt19937 random;

    double number(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    }
    bool coin() { return random() % 2 == 0; }
    Vec2 point() { return {number(-10, 10), number(-10, 10)}; }
    Rgb colour(double most) {
        return coin() ? Rgb(number(0, most)) : Rgb(number(0, most), number(0, most), number(0, most));
    }
    Facing facing() { return coin() ? Facing::in : Facing::out; }

    Material material() {
        const Glossy glossy{colour(1), coin() ? Glossy{}.exponent : number(0, 1e6)};
        switch (random() % 6) {
            case 0:
                return Diffuse{colour(1)};
            case 1:
                return Mirror{colour(1)};
            case 2:
                return glossy;
            case 3:
                return Dielectric{number(1, 10), colour(1e6)};
            case 4:
                return Mix{{colour(1)}, Mirror{colour(1)}, number(0, 1)};
            default:
                return Mix{{colour(1)}, glossy, coin() ? 0.5 : number(0, 1)};
        }
    }

    Geometry geometry() {
        const Vec2 p = point();
        const auto segments = static_cast<std::uint32_t>(3 + random() % 20);
        switch (random() % 7) {
            case 0:
                return SegmentShape{p, point()};
            case 1:
                return PolylineShape{{p, point(), point()}};
            case 2:
                return PolygonShape{{p, point(), point()}};
            case 3:
                return BoxShape{p, p + Vec2(number(0.1, 1), number(0.1, 1)), facing()};
            case 4:
                return CircleShape{p, number(0.1, 10), segments, facing(), coin()};
            case 5:
                return ArcShape{p,        number(0.1, 10), number(-100, 0), number(1, 200),
                                segments, facing(),        coin()};
            default: {
                const double radius = number(0.5, 10);
                return LensShape{p,
                                 coin() ? Vec2(1, 0) : point(),
                                 1.0,
                                 number(1.5, 3),
                                 {coin() ? radius : 0.0, coin() ? radius : -number(0.5, 10)},
                                 segments,
                                 coin()};
            }
        }
    }

    SceneDescription scene() {
        SceneDescription scene;
        if (coin()) scene.title = "T";
        if (coin()) scene.environment.light.radiance = colour(10);
        for (std::size_t k = random() % 3; k > 0; --k) scene.environment.light.strip.push_back(colour(10));
        for (int k = 0; k < 4; ++k) scene.materials.push_back({"m" + std::to_string(k), material()});
        for (int k = 0; k < 6; ++k) {
            const NamedMaterial& named = scene.materials[random() % 4];
            Shape shape{coin() ? "" : "s" + std::to_string(k), geometry(), coin() ? "" : named.name};
            const bool isGlass =
                !shape.material.empty() && std::holds_alternative<Dielectric>(named.material);
            if (!isGlass && coin()) shape.emission = colour(5);
            if (!isGlass && coin()) shape.twoSided = true;
            scene.shapes.push_back(shape);
        }
        if (coin()) scene.lights.push_back(PointLight{point(), colour(3)});
        if (coin()) scene.lights.push_back(DirectionalLight{point(), colour(3)});
        if (coin()) scene.eye = EyeDescription{point(), point(), coin() ? 90.0 : number(1, 179)};
        return scene;
    }
};

}  // namespace

TEST_CASE("scenes of random things survive writing and reading") {
    RandomScene source{std::mt19937(5)};
    for (int i = 0; i < 500; ++i) {
        const SceneDescription scene = source.scene();
        checkRoundTrip(scene);
        CHECK(expandScene(parseScene(writeScene(scene), "x")) == expandScene(scene));
    }
}

TEST_CASE("the scenes of the lessons are usable and survive writing and reading") {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(LESSON_SCENES)) {
        if (entry.path().extension() != ".toml") continue;
        CAPTURE(entry.path().string());
        const SceneDescription scene = loadScene(entry.path());
        CHECK_FALSE(expandScene(scene).segments.empty());
        if (scene.environment.image.empty()) checkRoundTrip(scene);
        ++scenes;
    }
    CHECK(scenes > 0);
}
