#include "cases.h"

#include <toml++/toml.h>
#include <stdexcept>

#include "lessons/scene_file.h"

namespace halfdisk::test {
namespace {

std::string pathOf(const std::string& file) {
    return std::string(HALFDISK_TEST_CASES) + "/" + file;
}

double number(const toml::node_view<const toml::node>& node) {
    const auto value = node.value<double>();
    if (!value) throw std::runtime_error("a number is missing in an answers file");
    return *value;
}

Vec2 vec2(const toml::node_view<const toml::node>& node) {
    return {number(node[0]), number(node[1])};
}

Rgb colour(const toml::node_view<const toml::node>& node) {
    if (node.is_array()) return {number(node[0]), number(node[1]), number(node[2])};
    return Rgb(number(node));
}

Answer answerOf(const toml::table& node) {
    Answer answer;
    answer.query = node["query"].value_or(std::string());
    answer.wall = node["wall"].value_or(std::string());
    if (!answer.wall.empty()) answer.t = number(node["t"]);
    if (node["at"]) answer.at = vec2(node["at"]);
    if (node["normal"]) answer.normal = vec2(node["normal"]);
    if (const toml::array* depths = node["depth"].as_array())
        for (std::size_t k = 0; k < depths->size(); ++k) answer.depth.push_back(colour(node["depth"][k]));
    if (node["unlimited"]) answer.unlimited = colour(node["unlimited"]);
    answer.err = number(node["err"]);
    for (const auto& [key, value] : node)
        if (value.is_number()) answer.numbers[std::string(key.str())] = *value.value<double>();
    if (const toml::table* variances = node["variance"].as_table())
        for (const auto& [key, value] : *variances)
            answer.numbers[std::string(key.str())] = *value.value<double>();
    return answer;
}

std::uint32_t wallNamed(const Scene& scene, const std::string& name) {
    for (std::uint32_t i = 0; i < scene.segmentNames.size(); ++i)
        if (scene.segmentNames[i] == name) return i;
    throw std::runtime_error("no wall is called " + name);
}

}  // namespace

std::optional<Rgb> Answer::valueAt(std::size_t atDepth) const {
    if (atDepth < depth.size()) return depth[atDepth];
    if (unlimited && *unlimited == depth.back()) return unlimited;
    return std::nullopt;
}

Case readCase(const std::string& name) {
    Case result{name, expandScene(loadScene(pathOf(name + ".toml"))), {}};
    const toml::table file = toml::parse_file(pathOf(name + ".answers.toml"));
    const toml::array* answers = file["answer"].as_array();
    if (!answers) throw std::runtime_error("no answers for " + name);
    for (const auto& entry : *answers) result.answers.push_back(answerOf(*entry.as_table()));
    return result;
}

ShadedPoint pointOf(const SegmentIndex& index, const Answer& answer) {
    if (!answer.wall.empty()) return shadedPointOn(index, wallNamed(index.scene(), answer.wall), answer.t);
    return shadedPointAt(index, answer.at, answer.normal).value();
}

Rgb quantityOf(const SegmentIndex& index, const Answer& answer, const Rgb& irradiance) {
    return answer.query == "radiance" ? outgoingRadiance(index, pointOf(index, answer), irradiance)
                                      : irradiance;
}

std::optional<std::uint32_t> depthSetting(const Answer& answer, std::size_t depth) {
    if (answer.query != "radiance") return static_cast<std::uint32_t>(depth);
    if (depth == 0) return std::nullopt;
    return static_cast<std::uint32_t>(depth - 1);
}

}  // namespace halfdisk::test
