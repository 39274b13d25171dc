#include "app/key_editor.h"
#include "app/language.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

constexpr std::uint32_t kMostWallsOfShape = 2000;  // in the window; a file may have more
constexpr std::size_t kMostStripShown = 24;

}  // namespace

/// Side by side; the last one has the key beside it.
bool KeyEditor::editRow(const std::string& key, double* values, int count, const NumberRule& rule) const {
    const float all = ImGui::CalcItemWidth(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float each = (all - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
    const double size = std::abs(*std::max_element(
        values, values + count, [](double a, double b) { return std::abs(a) < std::abs(b); }));
    bool edited = false;
    for (int i = 0; i < count; ++i) {
        ImGui::PushItemWidth(each);
        const bool last = i + 1 == count;
        const std::string label = last ? key : "##" + key + "." + std::to_string(i);
        const float speed = static_cast<float>(std::clamp(0.005 * size, 1e-3, 1.0));
        edited = dragNumber<double>(ui.widgets, label.c_str(), values[i],
                                    {rule.least, rule.most, speed, "%.4g", false}) ||
                 edited;
        tooltip(rule.expected);
        ImGui::PopItemWidth();
        if (!last) ImGui::SameLine(0.0f, gap);
    }
    return edited;
}

bool KeyEditor::edit(const std::string& key, double& field, const NumberRule& rule) const {
    return editRow(key, &field, 1, rule);
}

bool KeyEditor::edit(const std::string& key, Vec2& field, const NumberRule& rule) const {
    return editRow(key, &field.x, 2, rule);
}

bool KeyEditor::edit(const std::string& key, Rgb& field, const NumberRule& rule) const {
    return editRow(key, &field.x, 3, rule);
}

bool KeyEditor::edit(const std::string& key, std::uint32_t& field, const WholeRule& rule) const {
    const auto least = static_cast<std::uint32_t>(rule.least);
    return dragNumber<std::uint32_t>(ui.widgets, key.c_str(), field,
                                     {least, std::max(kMostWallsOfShape, field), 0.2f, "%u", false});
}

bool KeyEditor::edit(const std::string& key, std::string& field, NameRule) const {
    if (key != "material") return inputText(ui.widgets, key.c_str(), field);
    std::vector<std::string_view> names{kDefaultMaterial};
    int index = 0;
    for (const NamedMaterial& named : scene.materials) {
        if (named.name == kDefaultMaterial) continue;
        if (named.name == field) index = static_cast<int>(names.size());
        names.push_back(named.name);
    }
    if (!combo(ui.widgets, key.c_str(), index, names)) return false;
    field = index == 0 ? std::string() : std::string(names[static_cast<std::size_t>(index)]);
    return true;
}

bool KeyEditor::edit(const std::string& key, std::string& field, const TextRule& rule) const {
    std::string typed = field;
    const bool entered = inputTextEntered(ui.widgets, key.c_str(), typed);
    tooltip("a PNG beside the scene's file; Enter reads it, an empty name takes it away");
    if (!entered || typed == field || typed.size() > rule.mostCharacters) return false;
    field = typed;
    return true;
}

bool KeyEditor::edit(const std::string& key, std::vector<Rgb>& strip, const StripRule& rule) const {
    if (strip.empty()) return false;
    if (!scene.environment.image.empty()) {
        text(ui.widgets, say("{}: {} angles, of the picture", key, strip.size()));
        return false;
    }
    bool edited = false;
    const double each = 360.0 / static_cast<double>(strip.size());
    for (std::size_t i = 0; i < std::min(strip.size(), kMostStripShown); ++i) {
        const std::string from = fmt::format("{:.4g}\u00b0", static_cast<double>(i) * each);
        edited = editRow(from, &strip[i].x, 3, kLightRule) || edited;
    }
    if (strip.size() > kMostStripShown) text(ui.widgets, say("and {} more", strip.size() - kMostStripShown));
    auto count = static_cast<std::uint32_t>(strip.size());
    const bool resized = dragNumber<std::uint32_t>(
        ui.widgets, "angles", count, {1, static_cast<std::uint32_t>(rule.most), 0.1f, "%u", false});
    tooltip("equal angles, counter-clockwise from +x");
    if (resized) strip.resize(count, strip.back());
    return edited || resized;
}

bool KeyEditor::edit(const std::string& key, std::vector<Vec2>& field, const PointsRule&) const {
    text(ui.widgets, key + ": " + std::to_string(field.size()) + ", pull them on the canvas");
    return false;
}

bool KeyEditor::edit(const std::string& key, std::variant<Mirror, Glossy>& part, PartRule) {
    KeyEditor inner{ui, scene};
    text(ui.widgets, key + (part.index() == 0 ? ": mirror" : ": glossy"));
    std::visit([&](auto& alternative) { keysOf(inner, alternative); }, part);
    return inner.changed;
}

}  // namespace halfdisk
