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

/// Points or colours, over as many lines as they need.
template <class Element>
std::string toToml(const std::vector<Element>& list) {
    std::string oneLine, lines, line;
    for (const Element& element : list) {
        const std::string text = toToml(element);
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

template <class Keys>
std::string inlineTable(Keys&& keysOfTable);

/// The writing end of scene_keys.h.
struct KeyWriter {
    std::string& out;
    std::string_view afterEach = "\n";

    template <class Field, class Rule>
    void required(std::string_view key, const Field& field, const Rule& rule) {
        out += fmt::format("{} = {}{}", key, text(field, rule), afterEach);
    }
    template <class Field, class Rule>
    void optional(std::string_view key, const Field& field, const Field& fallback, const Rule& rule) {
        if (!(field == fallback)) required(key, field, rule);
    }
    template <class Field, class Rule, class Map>
    void synonym(std::string_view, std::string_view, const Field&, const Rule&, const Map&) {}

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
    static std::string text(Vec2 radii, CurvatureRule) {
        return radii.x == radii.y ? toToml(radii.x) : toToml(radii);
    }
    static std::string text(const Diffuse& part, PartRule) { return toToml(part.albedo); }
    static std::string text(const std::variant<Mirror, Glossy>& part, PartRule) {
        if (const auto* mirror = std::get_if<Mirror>(&part)) return toToml(mirror->reflectance);
        return inlineTable([&](KeyWriter& keys) { writeMaterial(keys, Material(std::get<Glossy>(part))); });
    }

    static void writeMaterial(KeyWriter& keys, Material material) {
        keys.required("type", std::string(kMaterialTypes[material.index()].name), NameRule{});
        std::visit([&](auto& alternative) { keysOf(keys, alternative); }, material);
    }
};

template <class Keys>
std::string inlineTable(Keys&& keysOfTable) {
    constexpr std::string_view kComma = ", ";
    std::string inside;
    KeyWriter keys{inside, kComma};
    keysOfTable(keys);
    if (!inside.empty()) inside.erase(inside.size() - kComma.size());
    return fmt::format("{{ {} }}", inside);
}

}  // namespace

std::string writeScene(const SceneDescription& description) {
    // The keys are visited in a copy: reading and writing share one list, and reading must change what it
    // visits.
    SceneDescription scene = description;
    std::string out;
    KeyWriter keys{out};
    keys.optional("title", scene.title, std::string(), kTitleRule);
    if (!scene.environment.image.empty()) scene.environment.light.strip.clear();
    if (scene.environment != Sky{})
        out += fmt::format("environment = {}\n",
                           inlineTable([&](KeyWriter& inside) { keysOf(inside, scene.environment); }));
    const auto startTable = [&](const std::string& header) {
        out += (out.empty() ? "" : "\n") + header + "\n";
    };
    for (NamedMaterial& named : scene.materials) {
        startTable(fmt::format("[material.{}]", keyToToml(named.name)));
        KeyWriter::writeMaterial(keys, named.material);
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
    if (scene.eye) {
        startTable("[eye]");
        keysOf(keys, *scene.eye);
    }
    return out;
}

void saveScene(const SceneDescription& description, const std::filesystem::path& path) {
    const std::string text = writeScene(description);
    parseScene(text, path.string(), [&](const std::string&) { return description.environment.light.strip; });
    writeFileAtomically(path, text);
}

}  // namespace halfdisk
