#include "wall_kind.h"

#include "overload.h"

namespace halfdisk {

std::string whyNotFlatDiffuse(const Scene& scene, std::uint32_t segment) {
    const Segment& wall = scene.segments[segment];
    return std::visit(Overload{[&](const Diffuse&) { return std::string(isSmooth(wall) ? "round" : ""); },
                               [](const Mirror&) { return std::string("a mirror"); },
                               [](const Glossy&) { return std::string("glossy"); },
                               [](const Dielectric&) { return std::string("glass"); },
                               [](const Mix&) { return std::string("a mix"); }},
                      scene.materials[wall.material]);
}

std::string quotedName(const Scene& scene, std::uint32_t segment) {
    const bool named = segment < scene.segmentNames.size() && !scene.segmentNames[segment].empty();
    return named ? '"' + scene.segmentNames[segment] + '"' : "segment " + std::to_string(segment);
}

}  // namespace halfdisk
