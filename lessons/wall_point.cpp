// Which point of which wall is meant by `floor:0.25`?
#include "lessons/wall_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "lessons/input_error.h"
#include "lessons/suggestions.h"
#include "lessons/utf8.h"

namespace halfdisk {
namespace {

/// A decimal number, with '.' in every locale.
std::optional<double> parseNumber(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789.eE+-") != std::string_view::npos)
        return std::nullopt;
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    double number = 0.0;
    if (!(stream >> number) || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
    return number;
}

}  // namespace

std::optional<std::uint32_t> findSegment(const Scene& scene, std::string_view name) {
    const auto found = std::find(scene.segmentNames.begin(), scene.segmentNames.end(), name);
    if (found == scene.segmentNames.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - scene.segmentNames.begin());
}

WallPoint parseWallPoint(std::string_view text, const Scene& scene) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos)
        throw InputError(fmt::format("\"{}\" is not a point on a wall, expected NAME:T, e.g. \"{}:0.5\"",
                                     excerpt(text),
                                     scene.segmentNames.empty() ? "floor" : scene.segmentNames.front()));
    const std::string_view name = text.substr(0, colon);
    const auto segment = findSegment(scene, name);
    if (!segment) {
        const std::vector<std::string_view> names(scene.segmentNames.begin(), scene.segmentNames.end());
        throw InputError(
            names.empty()
                ? fmt::format("there is no wall \"{}\": the scene has no walls, expected at least one", name)
                : fmt::format("there is no wall \"{}\", {}", excerpt(name), expectedOneOf(name, names)));
    }
    const auto t = parseNumber(text.substr(colon + 1));
    if (!t || !(*t >= 0.0 && *t <= 1.0))
        throw InputError(fmt::format("\"{}\" has no place on its wall, expected NAME:T with T from 0 to 1",
                                     excerpt(text)));
    return {*segment, *t};
}

}  // namespace halfdisk
