// How does a scene file become a SceneDescription, and what is refused on the way?
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "lessons/alternatives.h"
#include "lessons/geometry_check.h"
#include "lessons/key_reader.h"
#include "lessons/material_reader.h"
#include "lessons/scene_file.h"
#include "lessons/sky_image.h"
#include "lessons/text_file.h"

namespace halfdisk {
namespace {

/// A table of an array of tables, and which array that is.
struct ListedTable {
    std::size_t kind;  ///< index into kShapeKinds
    const TomlTable* table;
    TextPosition where;
};

class SceneReader {
 public:
    SceneReader(std::string file, const SkyLoader& skyLoader)
        : file_(std::move(file)), skyLoader_(skyLoader) {}

    SceneDescription read(const TomlValue& document) {
        TableReader table(file_, std::get<TomlTable>(document.data), document.where, "a scene file");
        KeyReader keys{table};
        keys.optional("title", scene_.title, std::string(), kTitleRule);
        const TomlValue* environment = table.optional("environment");
        const TomlValue* materials = table.optional("material");
        std::vector<ListedTable> shapes;
        for (std::size_t kind = 0; kind < kShapeKinds.size(); ++kind)
            if (const TomlValue* value = table.optional(kShapeKinds[kind]))
                list(kShapeKinds[kind], *value, kind, shapes);
        std::vector<ListedTable> lights;
        if (const TomlValue* value = table.optional("light")) list("light", *value, 0, lights);
        const TomlValue* eye = table.optional("eye");
        table.finish();

        if (environment != nullptr) readEnvironment(*environment);
        if (materials != nullptr) materials_ = MaterialTable(file_, *materials);
        std::stable_sort(shapes.begin(), shapes.end(), [](const ListedTable& a, const ListedTable& b) {
            return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
        });
        for (const ListedTable& shape : shapes) readShape(shape);
        checkEdgeNames();
        for (const ListedTable& light : lights) readLight(light);
        if (eye != nullptr) readEye(*eye);
        scene_.materials = materials_.list();
        return std::move(scene_);
    }

 private:
    void list(std::string_view name, const TomlValue& value, std::size_t kind,
              std::vector<ListedTable>& tables) const {
        for (const TomlValue& element : readArray(file_, name, value, fmt::format("tables [[{}]]", name)))
            tables.push_back({kind, &readTable(file_, name, element), element.where});
    }

    void readEnvironment(const TomlValue& value) {
        TableReader table(file_, readTable(file_, "environment", value), value.where, "environment");
        Sky sky;
        KeyReader keys{table};
        keysOf(keys, sky);
        table.finish();
        if (!sky.image.empty()) {
            const TextPosition where = table.at("image").where;
            if (table.has("strip"))
                failAt(file_, where, "\"image\" and \"strip\" say the same, expected one of them");
            sky.light.strip = loadSky(sky.image, where);
        }
        scene_.environment = std::move(sky);
    }

    std::vector<Rgb> loadSky(const std::string& image, TextPosition where) const {
        if (!skyLoader_)
            failAt(file_, where,
                   "\"image\" is relative to a scene file, but this scene is none, expected \"strip\"");
        try {
            return skyLoader_(image);
        } catch (const InputError& error) {
            failAt(file_, where, fmt::format("\"image\" cannot be used: {}", error.what()));
        }
    }

    void readShape(const ListedTable& listed) {
        TableReader table(file_, *listed.table, listed.where,
                          fmt::format("[[{}]]", kShapeKinds[listed.kind]));
        Shape shape;
        shape.geometry = alternative<Geometry>(listed.kind);
        KeyReader keys{table};
        keysOf(keys, shape);
        table.finish();

        // Counted before anything is expanded.
        segments_ += edgeCount(shape.geometry);
        if (segments_ > kMaxSegments)
            failAt(file_, listed.where,
                   fmt::format("the scene has {} segments up to here, expected at most {}", segments_,
                               kMaxSegments));
        if (const auto fault = findFault(shape.geometry)) {
            const TomlValue& value = table.at(fault->key);
            // A lens may have one radius for both of its surfaces.
            const auto* elements = fault->element ? std::get_if<TomlArray>(&value.data) : nullptr;
            failAt(file_, elements != nullptr ? (*elements)[*fault->element].where : value.where,
                   fault->text);
        }
        checkMaterial(table, shape);
        if (!shape.name.empty()) {
            const auto [other, isNew] = shapeOfName_.emplace(shape.name, scene_.shapes.size());
            if (!isNew)
                failAt(file_, table.at("name").where,
                       fmt::format("the name \"{}\" is taken by the shape at line {}, expected another name",
                                   excerpt(shape.name), nameAt_[other->second].line));
        }
        nameAt_.push_back(shape.name.empty() ? TextPosition{} : table.at("name").where);
        scene_.shapes.push_back(std::move(shape));
    }

    void checkMaterial(const TableReader& table, const Shape& shape) const {
        const std::string name = shape.material.empty() ? std::string(kDefaultMaterial) : shape.material;
        const Material* material = materials_.find(name);
        if (material == nullptr)
            failAt(file_, table.at("material").where,
                   fmt::format("there is no material \"{}\", {}", excerpt(name),
                               expectedOneOf(name, materials_.names([](std::size_t) { return true; }))));
        if (!std::holds_alternative<Dielectric>(*material)) return;
        if (shape.emission != Rgb(0.0))
            failAt(file_, table.at("emission").where,
                   "glass does not emit, expected no \"emission\" on a wall of a dielectric");
        if (shape.twoSided)
            failAt(file_, table.at("twoSided").where,
                   "glass has an outside, its front, and an inside, expected no \"twoSided\" on a wall of a "
                   "dielectric");
    }

    /// A shape called "block.0" beside a polygon "block" would share its name with the polygon's first edge.
    void checkEdgeNames() const {
        for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
            const std::string& name = scene_.shapes[i].name;
            const std::size_t dot = name.rfind('.');
            if (dot == std::string::npos) continue;
            const std::string number = name.substr(dot + 1);
            const auto base = shapeOfName_.find(name.substr(0, dot));
            if (base == shapeOfName_.end() || number.empty() || number.size() > 7) continue;
            if (number.find_first_not_of("0123456789") != std::string::npos) continue;
            if (number.size() > 1 && number[0] == '0') continue;
            const Geometry& geometry = scene_.shapes[base->second].geometry;
            if (std::holds_alternative<SegmentShape>(geometry) || std::stoull(number) >= edgeCount(geometry))
                continue;
            failAt(file_, nameAt_[i],
                   fmt::format(
                       "the name \"{}\" is taken by an edge of the shape at line {}, expected another name",
                       excerpt(name), nameAt_[base->second].line));
        }
    }

    void readLight(const ListedTable& listed) {
        TableReader table(file_, *listed.table, listed.where, "[[light]]");
        const TomlValue* type = table.required("type");
        if (type == nullptr) {
            // Which other keys are allowed depends on the type, so only its absence can be told.
            failAt(file_, listed.where,
                   fmt::format("[[light]] has no \"type\", {}", expectedOneOf({}, namesOf(kLightTypes))));
        }
        auto light = alternative<DeltaLight>(readNamed(file_, "type", *type, kLightTypes));
        KeyReader keys{table};
        std::visit([&](auto& alternative) { keysOf(keys, alternative); }, light);
        table.finish();
        const auto* directional = std::get_if<DirectionalLight>(&light);
        if (directional != nullptr && directional->direction == Vec2(0.0))
            failAt(file_, table.at("direction").where,
                   "\"direction\" is [0, 0], expected a direction of travel");
        scene_.lights.push_back(light);
    }

    void readEye(const TomlValue& value) {
        if (std::holds_alternative<TomlArray>(value.data))
            failAt(file_, value.where, "\"eye\" is an array, expected one table [eye]: a scene has one eye");
        TableReader table(file_, readTable(file_, "eye", value), value.where, "[eye]");
        EyeDescription eye;
        KeyReader keys{table};
        keysOf(keys, eye);
        table.finish();
        if (eye.direction == Vec2(0.0))
            failAt(file_, table.at("direction").where,
                   "\"direction\" is [0, 0], expected the direction that the eye looks in");
        scene_.eye = eye;
    }

    std::string file_;
    const SkyLoader& skyLoader_;
    SceneDescription scene_;
    std::uint64_t segments_ = 0;
    MaterialTable materials_;
    std::unordered_map<std::string, std::size_t> shapeOfName_;
    std::vector<TextPosition> nameAt_;  ///< parallel to the shapes; line 0 where there is no name
};

}  // namespace

SceneDescription parseScene(std::string_view text, std::string_view fileName, const SkyLoader& skyLoader) {
    const std::string file(fileName);
    return SceneReader(file, skyLoader).read(parseToml(text, file));
}

SceneDescription loadScene(const std::filesystem::path& path) {
    const auto beside = [&](const std::string& image) { return readSky(path.parent_path() / image); };
    return parseScene(readTextFile(path), path.string(), beside);
}

}  // namespace halfdisk
