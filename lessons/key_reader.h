// How does each kind of value in scene_keys.h come out of a table?
#pragma once

#include <fmt/format.h>

#include "lessons/material_reader.h"
#include "lessons/scene_keys.h"
#include "lessons/table_reader.h"

namespace halfdisk {

/// The reading end of scene_keys.h.
struct KeyReader {
    TableReader& table;
    const MaterialTable* materials = nullptr;  ///< for the parts of a mix

    template <class Field, class Rule>
    void required(std::string_view key, Field& field, const Rule& rule) {
        if (const TomlValue* value = table.required(key)) read(key, *value, field, rule);
    }
    template <class Field, class Rule>
    void optional(std::string_view key, Field& field, const Field& fallback, const Rule& rule) {
        field = fallback;
        if (const TomlValue* value = table.optional(key)) read(key, *value, field, rule);
    }

    template <class Field, class Rule, class Map>
    void synonym(std::string_view key, std::string_view ofKey, Field& field, const Rule& rule,
                 const Map& map) {
        const TomlValue* value = table.optional(key);
        if (value == nullptr) return;
        if (table.has(ofKey))
            failAt(table.file(), value->where,
                   fmt::format("\"{}\" and \"{}\" say the same, expected one of them", key, ofKey));
        read(key, *value, field, rule);
        field = map(field);
    }

    void read(std::string_view key, const TomlValue& value, double& field, const NumberRule& rule) {
        field = readNumber(table.file(), key, value, rule);
    }
    void read(std::string_view key, const TomlValue& value, Vec2& field, const NumberRule& rule) {
        field = readPoint(table.file(), key, value, rule);
    }
    void read(std::string_view key, const TomlValue& value, Rgb& field, const NumberRule& rule) {
        field = readColour(table.file(), key, value, rule);
    }
    void read(std::string_view key, const TomlValue& value, std::uint32_t& field, const WholeRule& rule) {
        field = static_cast<std::uint32_t>(readWhole(table.file(), key, value, rule));
    }
    void read(std::string_view key, const TomlValue& value, bool& field, FlagRule) {
        field = readFlag(table.file(), key, value);
    }
    void read(std::string_view key, const TomlValue& value, std::string& field, NameRule) {
        field = readName(table.file(), key, value);
    }
    void read(std::string_view key, const TomlValue& value, std::string& field, const TextRule& rule) {
        field = readText(table.file(), key, value, rule);
    }
    template <class Enum, std::size_t Count>
    void read(std::string_view key, const TomlValue& value, Enum& field,
              const std::array<Named<Enum>, Count>& names) {
        field = readNamed(table.file(), key, value, names);
    }
    void read(std::string_view key, const TomlValue& value, std::vector<Vec2>& field, PointsRule rule) {
        const TomlArray& points = readArray(table.file(), key, value, "an array of points [[x, y], ...]");
        if (points.size() < rule.least)
            failAt(table.file(), value.where,
                   fmt::format("\"{}\" has {}, expected at least {}", key, counted(points.size(), "point"),
                               rule.least));
        for (const TomlValue& point : points)
            field.push_back(readPoint(table.file(), key, point, kCoordinateRule));
    }
    void read(std::string_view key, const TomlValue& value, Vec2& field, CurvatureRule) {
        field = std::holds_alternative<TomlArray>(value.data)
                    ? readPoint(table.file(), key, value, kCurvatureRule, "one radius or two [r1, r2]")
                    : Vec2(readNumber(table.file(), key, value, kCurvatureRule));
    }
    void read(std::string_view key, const TomlValue& value, Diffuse& field, PartRule) {
        field = readDiffusePart(table.file(), key, value, *materials);
    }
    void read(std::string_view key, const TomlValue& value, std::variant<Mirror, Glossy>& field, PartRule) {
        field = readSpecularPart(table.file(), key, value, *materials);
    }
    void read(std::string_view key, const TomlValue& value, std::vector<Rgb>& field, StripRule rule) {
        const TomlArray& colours = readArray(table.file(), key, value, "an array of colours");
        if (colours.empty() || colours.size() > rule.most)
            failAt(table.file(), value.where,
                   fmt::format("\"{}\" has {} entries, expected 1 to {}", key, colours.size(), rule.most));
        for (const TomlValue& colour : colours)
            field.push_back(readColour(table.file(), key, colour, kLightRule));
    }
};

}  // namespace halfdisk
