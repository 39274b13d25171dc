// Which walls are meant by a list of names? A shape's name stands for all its walls, in their order.
#include "app/wall_names.h"

#include <algorithm>

#include "app/cli_arguments.h"
#include "lessons/wall_point.h"

namespace halfdisk {
namespace {

constexpr std::string_view kAll = "all";

/// `disk` of `disk.17`; the name itself if it has no number.
std::string_view shapeOf(std::string_view wall) {
    const std::size_t dot = wall.rfind('.');
    const bool numbered = dot != std::string_view::npos && dot + 1 < wall.size() &&
                          wall.find_first_not_of("0123456789", dot + 1) == std::string_view::npos;
    return numbered ? wall.substr(0, dot) : wall;
}

std::vector<std::uint32_t> wallsNamed(std::string_view name, const Scene& scene) {
    if (const auto wall = findSegment(scene, name)) return {*wall};
    std::vector<std::uint32_t> walls;
    for (std::uint32_t i = 0; i < scene.segmentNames.size(); ++i)
        if (name == kAll || shapeOf(scene.segmentNames[i]) == name) walls.push_back(i);
    return walls;
}

std::vector<std::string_view> shapesOf(const Scene& scene) {
    std::vector<std::string_view> names;
    for (const std::string& wall : scene.segmentNames)
        if (names.empty() || names.back() != shapeOf(wall)) names.push_back(shapeOf(wall));
    return names;
}

}  // namespace

std::vector<std::uint32_t> wallsArgument(std::string_view option, std::string_view text, const Scene& scene) {
    std::vector<std::uint32_t> walls;
    std::vector<bool> named(scene.segments.size());
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        const std::string_view name = text.substr(start, end - start);
        const std::vector<std::uint32_t> found = wallsNamed(name, scene);
        if (found.empty())
            failArgument(option, name,
                         scene.segments.empty()
                             ? std::string("names no wall: the scene has none")
                             : fmt::format("names no wall, {}", expectedOneOf(name, shapesOf(scene))));
        for (const std::uint32_t wall : found) {
            if (named[wall])
                failArgument(option, text,
                             fmt::format("names the wall \"{}\" twice, expected each once",
                                         excerpt(scene.segmentNames[wall])));
            named[wall] = true;
            walls.push_back(wall);
        }
        start = end + 1;
    }
    return walls;
}

}  // namespace halfdisk
