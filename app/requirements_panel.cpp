// What does this scene require? The advisor: its plan in a sentence, every requirement with the reason and
// what it costs to do otherwise, switches to force it, and a button that does what the plan says.
#include <algorithm>
#include <array>

#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/plot_words.h"
#include "app/requirements_text.h"
#include "app/requirements_words.h"
#include "app/sheet.h"

namespace halfdisk {
namespace {

/// Design pixels: title, value and switch stand side by side.
constexpr float kWide = 480;
/// Design pixels: the plan stays while the list below it scrolls.
constexpr float kHigh = 270;

constexpr std::string_view kAsNeeded = "as needed";
constexpr std::array<std::string_view, 12> kCounts{"1",  "2",  "3",  "4",  "6",  "8",
                                                   "12", "16", "24", "32", "48", "64"};

float switchWidth() {
    return textSize(kAsNeeded).x + ImGui::GetFrameHeight() + 2.5f * ImGui::GetStyle().FramePadding.x;
}

/// As the scene needs it, off, or on and so many.
void forceSwitch(const Ui& ui, const RequirementInfo& info) {
    InstrumentSettings settings = ui.state.instruments;
    const auto now = forcedValue(settings, info.id);
    const std::string own = now ? std::to_string(*now) : std::string();
    std::vector<std::string_view> names{kAsNeeded, "off"};
    if (info.kind == Switch::onOff) {
        names.emplace_back("on");
    } else {
        names.insert(names.end(), kCounts.begin(), kCounts.end());
        if (now && *now > 0 && std::find(names.begin(), names.end(), own) == names.end())
            names.push_back(own);
    }
    int index = !now ? 0 : *now == 0 ? 1 : 2;
    if (index == 2 && info.kind == Switch::number)
        index = static_cast<int>(std::find(names.begin(), names.end(), own) - names.begin());
    ImGui::PushItemWidth(switchWidth());
    const std::string label = "##" + std::string(info.name);
    const bool changed = combo(ui.widgets, label.c_str(), index, names);
    tooltip(info.asks);
    ImGui::PopItemWidth();
    if (!changed) return;
    const std::string_view chosen = names[static_cast<std::size_t>(index)];
    std::optional<std::uint32_t> value;
    if (chosen != kAsNeeded) value = chosen == "off" ? 0u : chosen == "on" ? 1u : 0u;
    if (index > 1 && info.kind == Switch::number)
        value = static_cast<std::uint32_t>(std::stoul(std::string(chosen)));
    force(settings, info.id, value);
    ui.commands.push_back(SetInstruments{settings});
}

/// Words in lines no wider than `width`, cut at blanks.
std::vector<std::string> linesOf(const std::string& words, float width) {
    std::vector<std::string> lines;
    std::string line;
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        const std::string next =
            line.empty() ? words.substr(at, end - at) : line + " " + words.substr(at, end - at);
        if (!line.empty() && textSize(next).x > width) {
            lines.push_back(line);
            line = words.substr(at, end - at);
        } else {
            line = next;
        }
        at = end + 1;
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

/// From where the next line of words goes, down the list.
struct Writer {
    const Ui& ui;
    ImVec2 at;
    float width;
    float line = 1.2f * ImGui::GetFontSize();

    void words(ImU32 color, const std::string& text, std::string_view hover, const std::string& id) {
        drawText(ui, at, color, text);
        ImGui::SetCursorScreenPos(at);
        ImGui::InvisibleButton(id.c_str(), {width, line});
        tooltip(hover);
        at.y += line;
    }
};

void title(const Ui& ui, const RequirementLine& line, const Writer& writer, bool wide) {
    const bool switched = infoOf(line.id).kind != Switch::none;
    const float row = switched ? ImGui::GetFrameHeight() : writer.line;
    const float drop = (row - ImGui::GetFontSize()) / 2.0f;
    const float room = wide ? 0.47f * writer.width : writer.width;
    drawText(ui, {writer.at.x, writer.at.y + (wide ? drop : 0.0f)}, ui.palette.ink,
             firstThatFits({line.title}, room - 8 * ui.scale, ui.fonts.strong), Align::left, ui.fonts.strong);
    const ImVec2 second{wide ? writer.at.x + room : writer.at.x, writer.at.y + (wide ? 0.0f : writer.line)};
    const ImU32 color = line.forced ? ui.palette.error : line.on ? ui.palette.exact : ui.palette.inkSoft;
    drawText(ui, {second.x, second.y + drop}, color, line.value, Align::left,
             line.forced || line.on ? ui.fonts.strong : nullptr);
    if (!switched) return;
    ImGui::SetCursorScreenPos({writer.at.x + writer.width - switchWidth(), second.y});
    forceSwitch(ui, infoOf(line.id));
}

void requirement(const Ui& ui, const RequirementLine& line, Writer& writer) {
    const RequirementInfo& info = infoOf(line.id);
    const bool wide = writer.width > kWide * ui.scale;
    title(ui, line, writer, wide);
    writer.at.y +=
        (wide ? 0.0f : writer.line) + (info.kind == Switch::none ? writer.line : ImGui::GetFrameHeight());
    std::string hover = fmt::format("{}\n{}", tr(info.asks), line.reason);
    for (const std::string& cost : line.costsByTime) hover += fmt::format("\n{}", cost);
    if (info.kind == Switch::none) hover += say("\nIt can't be switched: {}.", tr(info.fixed));
    const std::string id(info.name);
    writer.words(ui.palette.inkSoft, firstThatFits({line.reason}, writer.width), hover, id + " reason");
    for (std::size_t i = 0; i < line.costs.size(); ++i)
        for (const std::string& part : linesOf(line.costs[i], writer.width))
            writer.words(ui.palette.ink, part, hover, fmt::format("{} cost {} {}", id, i, writer.at.y));
    writer.at.y += 0.35f * writer.line;
}

void list(const Ui& ui) {
    const std::vector<RequirementLine> lines = requirementLines(ui.state);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    Writer writer{ui, origin, ImGui::GetContentRegionAvail().x};
    const OnSheet drawing(ui, "requirements",
                          {writer.width, ImGui::GetScrollMaxY() + ImGui::GetWindowHeight()});
    for (const RequirementLine& line : lines) requirement(ui, line, writer);
    for (const std::string& part : linesOf(everythingWords(ui.state), writer.width))
        writer.words(ui.palette.ink, part, "nothing is left out: paths from both ends, joined in every way",
                     fmt::format("everything {}", writer.at.y));
    ImGui::SetCursorScreenPos(writer.at);
    ImGui::Dummy({writer.width, 0.0f});
}

void doIt(const Ui& ui) {
    const AppState& state = ui.state;
    const std::optional<Maker> maker = plannedMaker(state);
    const bool done = maker && state.makers.first == maker;
    ImGui::BeginDisabled(!maker || done || state.rules.isLocked(Control::estimator));
    sameLineIfFits("Do it so");
    if (button(ui.widgets, "Do it so")) {
        ui.commands.push_back(SetMakers{{maker, state.makers.second, state.makers.equal}});
        const View view = state.scene->scene.eye ? View::eye : View::profile;
        if (!state.shows(view)) ui.commands.push_back(SetView{view, true});
    }
    ImGui::EndDisabled();
    tooltip(done ? say("The pictures are made so: {}", plannedMakerWords(state))
                 : say("makes the pictures as the plan says: {}", plannedMakerWords(state)));
}

void settings(const Ui& ui) {
    InstrumentSettings settings = ui.state.instruments;
    double percent = 100.0 * settings.tolerance;
    ImGui::PushItemWidth(textSize("0.0001 %").x + 2 * ImGui::GetStyle().FramePadding.x);
    constexpr double kLeast = 100.0 * kLeastTolerance, kMost = 100.0 * kMostTolerance;
    if (dragNumber<double>(ui.widgets, "tolerance", percent,
                           {kLeast, kMost, static_cast<float>(kMost / 400.0), "%.3g %%", true})) {
        settings.tolerance = std::clamp(percent / 100.0, kLeastTolerance, kMostTolerance);
        ui.commands.push_back(SetInstruments{settings});
    }
    ImGui::PopItemWidth();
    tooltip("share of the light that may be missing, or noise");
    doIt(ui);
    if (settings.forced.empty()) return;
    sameLineIfFits("Force nothing");
    if (button(ui.widgets, "Force nothing")) {
        settings.forced.clear();
        ui.commands.push_back(SetInstruments{settings});
    }
    tooltip("all as the scene needs it");
}

void head(const Ui& ui) {
    const InstrumentAnswers* answers = ui.state.answer ? &ui.state.answer->instruments : nullptr;
    const bool refused = answers && !answers->requirementsRefusal.empty();
    ImGui::PushStyleColor(ImGuiCol_Text, refused ? ui.palette.error : ui.palette.ink);
    textWrapped(ui.widgets, advice(ui.state));
    ImGui::PopStyleColor();
    settings(ui);
    const std::string lacks = adviceLacks(ui.state), forced = forcedWords(ui.state);
    if (!lacks.empty()) textWrapped(ui.widgets, lacks);
    if (forced.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.error);
    textWrapped(ui.widgets, forced);
    ImGui::PopStyleColor();
}

}  // namespace

void requirementsPanel(const Ui& ui, ImVec2 size) {
    beginChild("requirements", size, false);
    ImGui::PushFont(ui.fonts.strong);
    text(ui.widgets,
         firstThatFits({drawingTitle(ui.state, "requirements")}, ImGui::GetContentRegionAvail().x));
    ImGui::PopFont();
    const bool apart = size.y > kHigh * ui.scale && size.x > kWide * ui.scale;
    head(ui);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6 * ui.scale, 4 * ui.scale});
    if (apart) beginChild("requirement list", {0, 0}, true);
    ImGui::PopStyleVar();
    list(ui);
    if (apart) ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace halfdisk
