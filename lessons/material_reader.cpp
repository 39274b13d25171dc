// How do the materials of a scene file come out of it, those that are made of others too?
#include "lessons/material_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/alternatives.h"
#include "lessons/key_reader.h"
#include "lessons/scene_keys.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMixType = std::variant_size_v<Material> - 1;
static_assert(std::is_same_v<std::variant_alternative_t<kMixType, Material>, Mix>);

constexpr std::array<Named<std::size_t>, 1> kDiffuseTypes{{kMaterialTypes[0]}};
constexpr std::array<Named<std::size_t>, 2> kSpecularTypes{{kMaterialTypes[1], kMaterialTypes[2]}};

void readKeys(const std::string& file, const TomlTable& table, TextPosition where, std::string_view name,
              Material& material, const MaterialTable& materials) {
    TableReader reader(file, table, where,
                       fmt::format("{} of type \"{}\"", name, kMaterialTypes[material.index()].name));
    reader.optional("type");
    KeyReader keys{reader, &materials};
    std::visit([&](auto& alternative) { keysOf(keys, alternative); }, material);
    reader.finish();
}

template <std::size_t Count>
std::string quotedNames(const std::array<Named<std::size_t>, Count>& types) {
    std::string text;
    for (const auto& type : types) text += fmt::format("{}\"{}\"", text.empty() ? "" : " or ", type.name);
    return text;
}

/// What a name or a table stands for; it must be one of `types`.
template <std::size_t Count>
Material readPart(const std::string& file, std::string_view key, const TomlValue& value,
                  const MaterialTable& materials, const std::array<Named<std::size_t>, Count>& types) {
    if (const auto* table = std::get_if<TomlTable>(&value.data)) {
        const TomlEntry* type = table->find("type");
        if (type == nullptr)
            failAt(file, value.where,
                   fmt::format("the table \"{}\" has no \"type\", expected {}", key, quotedNames(types)));
        Material part = alternative<Material>(readNamed(file, "type", type->value, types));
        readKeys(file, *table, value.where, fmt::format("\"{}\"", key), part, materials);
        return part;
    }
    const auto* name = std::get_if<std::string>(&value.data);
    if (name == nullptr)
        failAt(
            file, value.where,
            fmt::format("\"{}\" is {}, expected a colour, a material's name or a table {{ type = {}, ... }}",
                        key, value.kind(), quotedNames(types)));
    const auto fits = [&](std::size_t kind) {
        return std::any_of(types.begin(), types.end(), [&](const auto& type) { return type.value == kind; });
    };
    const Material* named = materials.find(*name);
    if (named == nullptr) {
        const auto names = materials.names(fits);
        failAt(file, value.where,
               fmt::format("there is no material \"{}\", {}", excerpt(*name),
                           names.empty() ? "expected a colour or a table" : expectedOneOf(*name, names)));
    }
    if (!fits(named->index()))
        failAt(file, value.where,
               fmt::format("the material \"{}\" is of type \"{}\", expected one of type {}", excerpt(*name),
                           kMaterialTypes[named->index()].name, quotedNames(types)));
    return *named;
}

bool isColour(const TomlValue& value) {
    return std::holds_alternative<std::int64_t>(value.data) || std::holds_alternative<double>(value.data) ||
           std::holds_alternative<TomlArray>(value.data);
}

}  // namespace

MaterialTable::MaterialTable(const std::string& file, const TomlValue& value) {
    const TomlTable& table = readTable(file, "material", value);
    for (const TomlEntry& entry : table.entries) {
        checkName(file, entry.where, entry.key);
        const TomlEntry* type = readTable(file, entry.key, entry.value).find("type");
        const std::size_t index = type == nullptr ? 0 : readNamed(file, "type", type->value, kMaterialTypes);
        indexOf_.emplace(entry.key, list_.size());
        list_.push_back({entry.key, alternative<Material>(index)});
    }
    // Mixes last: their parts may be defined anywhere, but are no mixes themselves.
    for (const bool mixes : {false, true})
        for (std::size_t k = 0; k < list_.size(); ++k) {
            if ((list_[k].material.index() == kMixType) != mixes) continue;
            const TomlValue& at = table.entries[k].value;
            readKeys(file, std::get<TomlTable>(at.data), at.where,
                     fmt::format("[material.{}]", excerpt(list_[k].name)), list_[k].material, *this);
        }
}

const Material* MaterialTable::find(const std::string& name) const {
    const auto found = indexOf_.find(name);
    if (found != indexOf_.end()) return &list_[found->second].material;
    return name == kDefaultMaterial ? &default_ : nullptr;
}

std::vector<std::string_view> MaterialTable::names(const std::function<bool(std::size_t)>& fits) const {
    std::vector<std::string_view> names;
    for (const NamedMaterial& named : list_)
        if (named.name != kDefaultMaterial && fits(named.material.index())) names.push_back(named.name);
    if (fits(find(std::string(kDefaultMaterial))->index())) names.push_back(kDefaultMaterial);
    return names;
}

Diffuse readDiffusePart(const std::string& file, std::string_view key, const TomlValue& value,
                        const MaterialTable& materials) {
    if (isColour(value)) return {readColour(file, key, value, kShareRule)};
    return std::get<Diffuse>(readPart(file, key, value, materials, kDiffuseTypes));
}

std::variant<Mirror, Glossy> readSpecularPart(const std::string& file, std::string_view key,
                                              const TomlValue& value, const MaterialTable& materials) {
    if (isColour(value)) return Mirror{readColour(file, key, value, kShareRule)};
    const Material part = readPart(file, key, value, materials, kSpecularTypes);
    if (const auto* glossy = std::get_if<Glossy>(&part)) return *glossy;
    return std::get<Mirror>(part);
}

}  // namespace halfdisk
