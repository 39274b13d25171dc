// How does a description become the scene of the core, and what are its walls called?
#include "lessons/scene_expansion.h"

#include <fmt/format.h>

#include <array>
#include <unordered_map>
#include <unordered_set>

#include "lessons/input_error.h"

namespace halfdisk {
namespace {

DeltaLight withUnitDirection(DeltaLight light) {
    if (auto* directional = std::get_if<DirectionalLight>(&light))
        directional->direction = unitAlong(directional->direction);
    return light;
}

}  // namespace

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
    scene.environment = description.environment.light;
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
            scene.segments.push_back(
                {edge.a, edge.b, material, shape.emission, shape.twoSided, edge.normalA, edge.normalB});
            scene.segmentNames.push_back(single ? names[i] : fmt::format("{}.{}", names[i], number++));
        }
    }
    for (const DeltaLight& light : description.lights) scene.lights.push_back(withUnitDirection(light));
    if (description.eye)
        scene.eye = Eye{description.eye->position, unitAlong(description.eye->direction),
                        description.eye->fov * (kPi / 180.0)};
    return scene;
}

}  // namespace halfdisk
