// What makes the pictures? The estimator and its parameters, from the registry's own table; and what each
// picture cost.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/message_words.h"
#include "app/panels.h"
#include "app/picture_stages.h"
#include "lessons/maker_reader.h"

namespace halfdisk {
namespace {

bool chooseEstimator(const Ui& ui, const char* label, std::string& id) {
    std::vector<std::string_view> names;
    int index = 0;
    for (const EstimatorInfo* info : estimators()) {
        if (info->id == id) index = static_cast<int>(names.size());
        names.push_back(info->id);
    }
    const bool changed = combo(ui.widgets, label, index, names);
    tooltip(estimators()[static_cast<std::size_t>(index)]->meaning);
    if (changed) id = estimators()[static_cast<std::size_t>(index)]->id;
    return changed;
}

bool editParam(const Ui& ui, const ParamInfo& param, double& value) {
    const std::string label(param.name);
    bool changed = false;
    if (!param.choices.empty()) {
        int index = static_cast<int>(value);
        changed = combo(ui.widgets, label.c_str(), index, {param.choices.data(), param.choices.size()});
        value = index;
    } else if (param.whole) {
        auto whole = static_cast<std::int64_t>(value);
        const float speed = static_cast<float>(std::max(0.05, 0.01 * std::abs(value)));
        changed = dragNumber<std::int64_t>(ui.widgets, label.c_str(), whole,
                                           {static_cast<std::int64_t>(param.least),
                                            static_cast<std::int64_t>(param.most), speed, nullptr, false});
        value = static_cast<double>(whole);
    } else {
        const float speed = static_cast<float>(std::max(1e-4, 0.01 * std::abs(value)));
        changed = dragNumber<double>(ui.widgets, label.c_str(), value,
                                     {param.least, param.most, speed, "%.4g", false});
    }
    const std::string unit = param.unit.empty() ? "" : fmt::format(" ({})", param.unit);
    tooltip(fmt::format("{}{}: {}", tr(param.meaning), unit, trMessage(paramRange(param))));
    return changed;
}

/// `1.2 million rays, noise 3.4 %`.
void costLine(const Ui& ui, const std::shared_ptr<const LightPicture>& picture) {
    if (!picture) return;
    if (!picture->refusal.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.error);
        textWrapped(ui.widgets, trMessage(picture->refusal));
        ImGui::PopStyleColor();
        return;
    }
    const double rays = static_cast<double>(picture->film.counts.rays);
    std::string words = say("{:.2g} million rays", rays / 1e6);
    if (picture->noise) words += say(", noise {:.2g} %", 100.0 * *picture->noise);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
    textWrapped(ui.widgets, words);
    ImGui::PopStyleColor();
    tooltip(
        "Noise: the root mean square standard error of the pixels, as a share of their mean. Light that an "
        "estimator cannot find at all does not show in it.");
    if (picture->film.counts.nonFinite == 0) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.error);
    textWrapped(ui.widgets, say("{} values were not finite and left out", picture->film.counts.nonFinite));
    ImGui::PopStyleColor();
}

/// Of the field's colours.
void chooseScale(const Ui& ui) {
    std::array<std::string_view, kFieldScales.size()> names;
    int index = 0;
    for (std::size_t i = 0; i < kFieldScales.size(); ++i) {
        names[i] = kFieldScales[i].name;
        if (kFieldScales[i].value == ui.state.scale) index = static_cast<int>(i);
    }
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - textSize("estimator").x -
                         2 * ImGui::GetStyle().ItemInnerSpacing.x);
    if (combo(ui.widgets, "colours", index, names))
        ui.commands.push_back(SetFieldScale{kFieldScales[static_cast<std::size_t>(index)].value});
    ImGui::PopItemWidth();
    tooltip(kFieldScales[static_cast<std::size_t>(index)].meaning);
}

/// `LD 41 %  LDD 30 %`: by what the paths met.
void wordsLine(const Ui& ui, std::size_t all) {
    constexpr std::size_t kMostWords = 6;
    const auto& words = ui.state.answer->wayWords;
    std::string line;
    for (std::size_t i = 0; i < std::min(words.size(), kMostWords); ++i)
        line += fmt::format("{}{} {:.0f} %", i > 0 ? "   " : "", words[i].first,
                            100.0 * static_cast<double>(words[i].second) / static_cast<double>(all));
    if (line.empty()) return;
    ImGui::PushFont(ui.fonts.code);
    textWrapped(ui.widgets, line);
    ImGui::PopFont();
    tooltip(
        "How many of the paths met what: L is the light, D a wall that scatters, S a mirror or a skin of "
        "glass. The commonest ones.");
}

void censusLine(const Ui& ui) {
    const AppState& state = ui.state;
    if (!state.shows(View::paths) || !state.answer || !state.answer->ways) return;
    const std::vector<LightWay>& ways = *state.answer->ways;
    std::string words = say("{} paths of light followed", ways.size());
    if (state.answer->throughPupil)
        words += say(", {} through a pupil of {:g} cm at the eye", *state.answer->throughPupil,
                     200.0 * kPupilRadius);
    textWrapped(ui.widgets, words);
    tooltip(say("The first {} of them are drawn.", std::min<std::size_t>(kWaysDrawn, ways.size())));
    wordsLine(ui, ways.size());
}

}  // namespace

void makersPanel(const Ui& ui) {
    const AppState& state = ui.state;
    censusLine(ui);
    const std::optional<View> view = state.mainPicture();
    if (!view) return;
    Makers makers = state.makers;
    Maker first = makers.first ? *makers.first : usualMaker(*view);
    float labels = textSize("estimator").x;
    if (state.isUnlocked(Control::params))
        for (const ParamInfo& param : findEstimator(first.estimator)->params)
            labels = std::max(labels, textSize(param.name).x);
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - labels -
                         2 * ImGui::GetStyle().ItemInnerSpacing.x);
    const bool both = makers.second.has_value();
    bool changed = false;
    ImGui::BeginDisabled(!state.isUnlocked(Control::estimator));
    if (chooseEstimator(ui, both ? "A" : "estimator", first.estimator)) {
        first = makerOf(first.estimator);
        changed = true;
    }
    ImGui::EndDisabled();
    ImGui::BeginDisabled(!state.isUnlocked(Control::params));
    const EstimatorInfo& info = *findEstimator(first.estimator);
    if (state.isUnlocked(Control::params))
        for (std::size_t i = 0; i < info.params.size(); ++i)
            changed = editParam(ui, info.params[i], first.params[i]) || changed;
    ImGui::EndDisabled();
    if (state.answer) costLine(ui, state.answer->pictures.of(*view));
    if (both) {
        ImGui::BeginDisabled(!state.isUnlocked(Control::estimator));
        if (chooseEstimator(ui, "B", makers.second->estimator)) {
            makers.second = makerOf(makers.second->estimator);
            changed = true;
        }
        ImGui::EndDisabled();
        if (state.answer) costLine(ui, state.answer->against.of(*view));
    }
    ImGui::PopItemWidth();
    if (changed) makers.first = first;
    if (state.isUnlocked(Control::estimator)) {
        bool compare = both;
        if (toggle(ui.widgets, "Compare", compare)) {
            makers.first = first;
            makers.second = compare ? std::optional(usualMaker(*view)) : std::nullopt;
        }
        tooltip(
            "A second estimator beside the first: fields left and right, strips below each other, profiles "
            "in one plot");
    }
    if (!(makers == state.makers)) ui.commands.push_back(SetMakers{makers});
    if (state.shows(View::field)) chooseScale(ui);
}

}  // namespace halfdisk
