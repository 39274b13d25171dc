// How do the materials of a scene file come out of it, those that are made of others too?
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "lessons/scene_description.h"
#include "lessons/toml_document.h"

namespace halfdisk {

/// The materials of a file, in its order and by name.
class MaterialTable {
 public:
    MaterialTable() = default;
    /// Reads the table [material]. Throws InputError.
    MaterialTable(const std::string& file, const TomlValue& value);

    const std::vector<NamedMaterial>& list() const { return list_; }
    /// Null if there is none; the default material is always there.
    const Material* find(const std::string& name) const;
    /// Names of those whose type (index into kMaterialTypes) fits, the default one's last.
    std::vector<std::string_view> names(const std::function<bool(std::size_t type)>& fits) const;

 private:
    std::vector<NamedMaterial> list_;
    std::unordered_map<std::string, std::size_t> indexOf_;
    Material default_ = Diffuse{};
};

/// A part of a mix: a colour, the name of a material, or a table. Throws InputError at the value.
Diffuse readDiffusePart(const std::string& file, std::string_view key, const TomlValue& value,
                        const MaterialTable& materials);
std::variant<Mirror, Glossy> readSpecularPart(const std::string& file, std::string_view key,
                                              const TomlValue& value, const MaterialTable& materials);

}  // namespace halfdisk
