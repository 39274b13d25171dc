// How is a SceneDescription written so that it reads back equal, bit for bit and byte for byte?
#include <fmt/format.h>

#include <algorithm>

#include "lessons/atomic_file.h"
#include "lessons/scene_file.h"
#include "lessons/scene_keys.h"

namespace halfdisk {
namespace {

constexpr std::size_t kLineWidth = 100;

/// The shortest digits that read back as the same double, marked as a real number.
std::string toToml(double number) {
    std::string text = fmt::format("{}", number);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string toToml(Vec2 point) {
    return fmt::format("[{}, {}]", toToml(point.x), toToml(point.y));
}

std::string toToml(const Rgb& colour) {
    if (colour == Rgb(colour.x)) return toToml(colour.x);
    return fmt::format("[{}, {}, {}]", toToml(colour.x), toToml(colour.y), toToml(colour.z));
}

std::string toToml(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (byte < 0x20u || byte == 0x7Fu) {
            quoted += fmt::format("\\u{:04X}", byte);
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

std::string toToml(const std::vector<Vec2>& points) {
    std::string oneLine, lines, line;
    for (const Vec2 point : points) {
        const std::string text = toToml(point);
        oneLine += (oneLine.empty() ? "" : ", ") + text;
        if (!line.empty() && line.size() + text.size() + 1 > kLineWidth) {
            lines += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "    " : " ") + text + ",";
    }
    if (oneLine.size() <= kLineWidth) return fmt::format("[{}]", oneLine);
    return fmt::format("[\n{}{}\n]", lines, line);
}

/// A table's name as part of [material.NAME].
std::string keyToToml(const std::string& key) {
    const auto isBare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    return !key.empty() && std::all_of(key.begin(), key.end(), isBare) ? key : toToml(key);
}

/// The writing end of scene_keys.h.
struct KeyWriter {
    std::string& out;

    template <class Field, class Rule>
    void required(std::string_view key, const Field& field, const Rule& rule) {
        out += fmt::format("{} = {}\n", key, text(field, rule));
    }
    template <class Field, class Rule>
    void optional(std::string_view key, const Field& field, const Field& fallback, const Rule& rule) {
        if (!(field == fallback)) required(key, field, rule);
    }

    template <class Field, class Rule>
    static std::string text(const Field& field, const Rule&) {
        return toToml(field);
    }
    static std::string text(std::uint32_t field, const WholeRule&) { return fmt::format("{}", field); }
    static std::string text(bool field, FlagRule) { return field ? "true" : "false"; }
    template <class Enum, std::size_t Count>
    static std::string text(Enum field, const std::array<Named<Enum>, Count>& names) {
        return toToml(std::string(nameOf(names, field)));
    }
};

}  // namespace

std::string writeScene(const SceneDescription& description) {
    // The keys are visited in a copy: reading and writing share one list, and reading must change what it
    // visits.
    SceneDescription scene = description;
    std::string out;
    KeyWriter keys{out};
    keys.optional("title", scene.title, std::string(), kTitleRule);
    if (scene.environment != Rgb(0.0))
        out += fmt::format("environment = {{ radiance = {} }}\n", toToml(scene.environment));
    const auto startTable = [&](const std::string& header) {
        out += (out.empty() ? "" : "\n") + header + "\n";
    };
    for (NamedMaterial& named : scene.materials) {
        startTable(fmt::format("[material.{}]", keyToToml(named.name)));
        keys.required("type", std::string(kMaterialTypes[named.material.index()].name), NameRule{});
        std::visit([&](auto& material) { keysOf(keys, material); }, named.material);
    }
    for (Shape& shape : scene.shapes) {
        startTable(fmt::format("[[{}]]", kShapeKinds[shape.geometry.index()]));
        keysOf(keys, shape);
    }
    for (DeltaLight& light : scene.lights) {
        startTable("[[light]]");
        keys.required("type", std::string(kLightTypes[light.index()].name), NameRule{});
        std::visit([&](auto& alternative) { keysOf(keys, alternative); }, light);
    }
    return out;
}

void saveScene(const SceneDescription& description, const std::filesystem::path& path) {
    const std::string text = writeScene(description);
    parseScene(text, path.string());
    writeFileAtomically(path, text);
}

}  // namespace halfdisk
