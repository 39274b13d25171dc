// What makes the pictures? The estimator and its parameters, from the registry's own table; and what each
// picture cost.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/choose.h"
#include "app/draw_text.h"
#include "app/exact_stages.h"
#include "app/language.h"
#include "app/message_words.h"
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

/// `3.4`, `120`.
std::string percent(double share) {
    return share < 0.995 ? local(fmt::format("{:.2g}", 100.0 * share)) : fmt::format("{:.0f}", 100.0 * share);
}

/// `1.2 million rays, noise 3.4 %, error 3.6 %`: what a picture cost, and how good it is.
void costLine(const Ui& ui, View view, std::size_t side) {
    if (!ui.state.answer) return;
    const LightAnswer& answer = *ui.state.answer;
    const auto& picture = (side == 0 ? answer.pictures : answer.against).of(view);
    if (!picture) return;
    if (!picture->refusal.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.error);
        textWrapped(ui.widgets, trMessage(picture->refusal));
        ImGui::PopStyleColor();
        return;
    }
    const double rays = static_cast<double>(picture->film.counts.rays);
    const bool byTime = answer.asked.makers.second && answer.asked.makers.equal == Budget::time;
    std::string words = byTime ? say("{:.2g} million rays in {:.2f} s", rays / 1e6, picture->seconds)
                               : say("{:.2g} million rays", rays / 1e6);
    if (picture->firstLook) words += fmt::format("\n{}", tr("a coarse first look"));
    if (picture->noise) words += say("\nnoise {} %", percent(*picture->noise));
    const std::optional<double> error = errorOf(answer, view, side);
    if (error) words += say(", error {} %", percent(*error));
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
    textWrapped(ui.widgets, words);
    ImGui::PopStyleColor();
    tooltip(error ? "Noise: the root mean square standard error of the pixels, as a share of their mean. "
                    "Error: that "
                    "of their differences from the exact picture (of a field at some 400 of its cells). "
                    "Where it is clearly more than the noise, light is missing or is counted wrongly."
                  : "Noise: the root mean square standard error of the pixels, as a share of their mean. "
                    "Light that an "
                    "estimator cannot find at all does not show in it.");
    if (picture->film.counts.nonFinite == 0) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.error);
    textWrapped(ui.widgets, say("{} values were not finite and left out", picture->film.counts.nonFinite));
    ImGui::PopStyleColor();
}

/// As wide as leaves room for the label.
float widthBeside(std::string_view label) {
    return ImGui::GetContentRegionAvail().x - textSize(label).x - 2 * ImGui::GetStyle().ItemInnerSpacing.x;
}

/// Of the field's colours.
void chooseScale(const Ui& ui) {
    FieldScale scale = ui.state.scale;
    ImGui::PushItemWidth(widthBeside("estimator"));
    if (choose(ui, "colours", kFieldScales, scale)) ui.commands.push_back(SetFieldScale{scale});
    ImGui::PopItemWidth();
}

/// Where the exact picture is known, or could be.
void differenceSwitch(const Ui& ui) {
    const AppState& state = ui.state;
    const bool eye = state.shows(View::eye) && state.scene->scene.eye;
    if (!(eye || state.shows(View::profile))) return;
    if (!state.scene->visibility) {
        if (state.shows(View::difference))
            textWrapped(ui.widgets, "no exact answer: not all walls are matt, or there are too many");
        return;
    }
    bool on = state.shows(View::difference);
    sameLineIfFits("Difference");
    if (toggle(ui.widgets, "Difference", on)) ui.commands.push_back(SetView{View::difference, on});
    tooltip("the exact strip and how far this one is from it; in the plot of the wall, the exact curve");
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
    tooltip(say("All of them are drawn as a cloud, the first {} as lines too.",
                std::min<std::size_t>(kWaysDrawn, ways.size())));
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
    costLine(ui, *view, 0);
    if (both) {
        ImGui::BeginDisabled(!state.isUnlocked(Control::estimator));
        if (chooseEstimator(ui, "B", makers.second->estimator)) {
            makers.second = makerOf(makers.second->estimator);
            changed = true;
        }
        ImGui::EndDisabled();
        costLine(ui, *view, 1);
        if (state.isUnlocked(Control::estimator) && choose(ui, "equal", kBudgets, makers.equal))
            changed = true;
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
    differenceSwitch(ui);
    if (!(makers == state.makers)) ui.commands.push_back(SetMakers{makers});
    if (state.shows(View::field)) chooseScale(ui);
}

}  // namespace halfdisk
