#include "app/scene_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/language.h"
#include "core/overload.h"
#include "lessons/scene_expansion.h"
#include "lessons/shape_edges.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostShapes = 300, kMostPoints = 24;

std::string pointsWords(const std::vector<Vec2>& points) {
    std::string words;
    for (std::size_t i = 0; i < std::min(points.size(), kMostPoints); ++i) {
        if (i > 0) words += ", ";
        words += placeWords(points[i]);
    }
    if (points.size() > kMostPoints) words += say(" and {} more", points.size() - kMostPoints);
    return words;
}

std::string_view facingWords(Facing facing) {
    return tr(facing == Facing::out ? "fronts outside" : "fronts inside");
}

std::string surfaceWords(double radius) {
    if (radius == 0.0) return std::string(tr("flat"));
    return say("{} with radius {:.6g} m", tr(radius > 0.0 ? "bulging" : "hollow"), std::abs(radius));
}

std::string geometryWords(const Geometry& geometry) {
    return std::visit(
        Overload{
            [](const SegmentShape& s) {
                return say("a wall from {} to {}, its front to the left of that way", placeWords(s.a),
                           placeWords(s.b));
            },
            [](const PolylineShape& s) {
                return say("{} walls from point to point: {}; fronts to the left of that way",
                           s.points.size() - 1, pointsWords(s.points));
            },
            [](const PolygonShape& s) {
                return say("a closed ring of {} walls: {}; fronts to the left of that way", s.points.size(),
                           pointsWords(s.points));
            },
            [](const BoxShape& s) {
                return say("a box from {} to {}, {}", placeWords(s.min), placeWords(s.max),
                           facingWords(s.facing));
            },
            [](const CircleShape& s) {
                return say("a {}circle about {} with radius {:.6g} m, of {} walls, {}",
                           s.smooth ? tr("smooth ") : "", placeWords(s.center), s.radius, s.segments,
                           facingWords(s.facing));
            },
            [](const ArcShape& s) {
                return say(
                    "an arc about {} with radius {:.6g} m from {:.6g} to {:.6g} degrees, of {} walls, {}",
                    placeWords(s.center), s.radius, s.from, s.to, s.segments, facingWords(s.facing));
            },
            [](const LensShape& s) {
                return say(
                    "a lens about {} along {}, {:.6g} m high and {:.6g} m thick, one side {}, the other {}",
                    placeWords(s.center), placeWords(s.axis), s.height, s.thickness, surfaceWords(s.radius.x),
                    surfaceWords(s.radius.y));
            },
        },
        geometry);
}

std::string materialKind(const Material& material) {
    return std::visit(
        Overload{[](const Diffuse& m) { return say("matt, albedo {}", colourWords(m.albedo)); },
                 [](const Mirror& m) { return say("a mirror, reflectance {}", colourWords(m.reflectance)); },
                 [](const Glossy& m) {
                     return say("glossy, albedo {}, exponent {:.4g}", colourWords(m.albedo), m.exponent);
                 },
                 [](const Dielectric& m) {
                     std::string words = say("glass, index of refraction {:.4g}", m.ior);
                     if (m.absorption != Rgb(0.0))
                         words += say(", absorption {} per metre", colourWords(m.absorption));
                     return words;
                 },
                 [](const Mix& m) {
                     const Material specular =
                         std::visit([](const auto& part) { return Material(part); }, m.specular);
                     return say("a mix: {:.4g} of {}, the rest of {}", m.weight, materialKind(specular),
                                materialKind(m.diffuse));
                 }},
        material);
}

}  // namespace

std::string placeWords(Vec2 place) {
    return local(fmt::format("({:.6g}, {:.6g})", place.x + 0.0, place.y + 0.0));
}

std::string colourWords(const Rgb& colour) {
    return isGray(colour) ? shown(colour.x) : say("{} (red, green, blue)", shown(colour));
}

std::vector<std::string> wallWords(const SceneDescription& scene) {
    std::vector<std::string> words;
    const std::vector<std::string> names = shapeNames(scene.shapes);
    for (std::size_t i = 0; i < std::min(scene.shapes.size(), kMostShapes); ++i) {
        const Shape& shape = scene.shapes[i];
        std::string line = say("{}: {}; material {}", names[i], geometryWords(shape.geometry),
                               shape.material.empty() ? kDefaultMaterial : std::string_view(shape.material));
        if (shape.emission != Rgb(0.0))
            line += say("; it shines with radiance {} W/(m rad)", colourWords(shape.emission));
        if (shape.twoSided) line += tr("; both sides alike");
        words.push_back(line);
    }
    if (scene.shapes.size() > kMostShapes) {
        std::uint64_t walls = 0;
        for (std::size_t i = kMostShapes; i < scene.shapes.size(); ++i)
            walls += edgeCount(scene.shapes[i].geometry);
        words.push_back(say("and {} more, of {} walls in all", scene.shapes.size() - kMostShapes, walls));
    }
    return words;
}

std::vector<std::string> materialWords(const SceneDescription& scene) {
    std::vector<std::string> words;
    bool hasDefault = false, usesDefault = false;
    for (const NamedMaterial& named : scene.materials) {
        words.push_back(fmt::format("{}: {}", named.name, materialKind(named.material)));
        hasDefault = hasDefault || named.name == kDefaultMaterial;
    }
    for (const Shape& shape : scene.shapes)
        usesDefault = usesDefault || shape.material.empty() || shape.material == kDefaultMaterial;
    if (usesDefault && !hasDefault)
        words.push_back(fmt::format("{}: {}", kDefaultMaterial, materialKind(Diffuse{})));
    return words;
}

std::vector<std::string> lightWords(const SceneDescription& scene) {
    std::vector<std::string> words;
    for (const DeltaLight& light : scene.lights)
        words.push_back(std::visit(
            Overload{[](const PointLight& l) {
                         return say("a point light at {}, intensity {} W/rad", placeWords(l.position),
                                    colourWords(l.intensity));
                     },
                     [](const DirectionalLight& l) {
                         return say(
                             "light from far away that travels along {}, irradiance {} W/m where it falls "
                             "straight on",
                             placeWords(l.direction), colourWords(l.irradiance));
                     }},
            light));
    const Environment& sky = scene.environment.light;
    if (sky.radiance == Rgb(0.0))
        words.emplace_back(tr("the sky is black"));
    else if (sky.strip.empty())
        words.push_back(say("the sky is even, radiance {} W/(m rad)", colourWords(sky.radiance)));
    else
        words.push_back(say("the sky is a ring of {} equal angles, radiance {} W/(m rad) times each",
                            sky.strip.size(), colourWords(sky.radiance)));
    return words;
}

std::string eyeWords(const SceneDescription& scene) {
    if (!scene.eye) return {};
    return say("The eye is at {}, looks along {}, and sees {:.4g} degrees.", placeWords(scene.eye->position),
               placeWords(scene.eye->direction), scene.eye->fov);
}

}  // namespace halfdisk
