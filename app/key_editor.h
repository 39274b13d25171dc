// How does a value of a scene file become a control? One for every kind of key, with the file's own rules.
#pragma once

#include <string>

#include "app/draw_text.h"
#include "lessons/scene_keys.h"

namespace halfdisk {

/// The editing end of scene_keys.h: what keysOf visits can be dragged, typed and chosen.
struct KeyEditor {
    const Ui& ui;
    const SceneDescription& scene;
    bool changed = false;

    template <class Field, class Rule>
    void required(std::string_view key, Field& field, const Rule& rule) {
        changed = edit(std::string(key), field, rule) || changed;
    }
    template <class Field, class Rule>
    void optional(std::string_view key, Field& field, const Field&, const Rule& rule) {
        required(key, field, rule);
    }
    template <class Field, class Rule, class Map>
    void synonym(std::string_view, std::string_view, const Field&, const Rule&, const Map&) {}

 private:
    bool edit(const std::string& key, double& field, const NumberRule& rule) const;
    bool edit(const std::string& key, Vec2& field, const NumberRule& rule) const;
    bool edit(const std::string& key, Rgb& field, const NumberRule& rule) const;
    bool edit(const std::string& key, Vec2& radii, CurvatureRule) const {
        return edit(key, radii, kCurvatureRule);
    }
    bool edit(const std::string& key, std::uint32_t& field, const WholeRule& rule) const;
    bool edit(const std::string& key, bool& field, FlagRule) const {
        return checkbox(ui.widgets, key.c_str(), field);
    }
    bool edit(const std::string& key, std::string& field, NameRule) const;
    /// Taken with Enter: a half of a name is none.
    bool edit(const std::string& key, std::string& field, const TextRule& rule) const;
    bool edit(const std::string& key, std::vector<Rgb>& strip, const StripRule& rule) const;
    bool edit(const std::string& key, std::vector<Vec2>& field, const PointsRule& rule) const;
    bool edit(const std::string& key, Diffuse& part, PartRule) { return edit(key, part.albedo, kShareRule); }
    bool edit(const std::string& key, std::variant<Mirror, Glossy>& part, PartRule);
    template <class Enum, std::size_t Count>
    bool edit(const std::string& key, Enum& field, const std::array<Named<Enum>, Count>& table) const {
        const std::vector<std::string_view> names = namesOf(table);
        int index = 0;
        for (std::size_t i = 0; i < Count; ++i)
            if (table[i].value == field) index = static_cast<int>(i);
        if (!combo(ui.widgets, key.c_str(), index, names)) return false;
        field = table[static_cast<std::size_t>(index)].value;
        return true;
    }

    bool editRow(const std::string& key, double* values, int count, const NumberRule& rule) const;
};

}  // namespace halfdisk
