// What is the light at P? The estimate with its standard error beside the exact value, and what it cost.
#include <fmt/format.h>

#include <cmath>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/message_words.h"
#include "app/panels.h"
#include "core/cover.h"
#include "core/wall_kind.h"

namespace halfdisk {
namespace {

/// A name on the left, a value on the right; below it if the column is too narrow for both.
void row(const Ui& ui, std::string_view name, std::string_view value, ImU32 color, std::string_view meaning) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float line = ImGui::GetFontSize() + 2 * ui.scale;
    const bool fits = textSize(name).x + textSize(value, ui.fonts.strong).x + 6 * ui.scale <= width;
    ImGui::Dummy({width, fits ? line : 2 * line});
    if (!meaning.empty()) tooltip(meaning);
    drawText(ui, origin, ui.palette.inkSoft, name);
    drawText(ui, {origin.x + width, origin.y + (fits ? 0.0f : line)}, color, value, Align::right,
             ui.fonts.strong);
}

std::string withThousands(std::uint64_t n) {
    const std::string digits = std::to_string(n);
    std::string grouped;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) grouped += ' ';
        grouped += digits[i];
    }
    return grouped;
}

/// The record's E once the playback has passed its end; before that only the steps are known.
bool runIsFinished(const AppState& state) {
    return !state.playback.stepping || state.playback.event >= state.eventCount();
}

/// Two digits; rounding's own noise is shown as 0.
std::string shownError(double error, double value) {
    return error <= 1e-12 * std::abs(value) ? "0" : local(fmt::format("{:.2g}", error));
}

/// Of one run: from its own samples where they are independent, else from the spread of many runs.
std::optional<Rgb> standardErrorOf(const LightAnswer& answer) {
    if (answer.standardError) return answer.standardError;
    if (answer.runs.count > 1) return glm::sqrt(answer.runs.variance());
    return std::nullopt;
}

void estimateRows(const Ui& ui, const LightAnswer& answer) {
    const Palette& palette = ui.palette;
    const Rgb E = answer.estimate.total();
    std::string value = shown(gray(E));
    if (const auto error = standardErrorOf(answer))
        value += fmt::format(" \u00b1 {}", shownError(gray(*error), gray(E)));
    const bool printed = ui.state.settings.defects != DefectSet{};
    row(ui, printed ? "E as printed" : "estimate of E", value, palette.estimate,
        "What the run of N samples says arrives at P (irradiance, W/m), plus or minus one standard error of "
        "such a run. "
        "Of a coloured light, the mean of red, green and blue.");
    if (ui.state.settings.maxDepth > 0 && !printed) {
        row(ui, "of it direct", shown(gray(answer.estimate.direct)), palette.ink,
            "Straight from lamps, lights and the sky.");
        row(ui, "of it indirect", shown(gray(answer.estimate.indirect)), palette.ink,
            "Scattered by a wall at least once before it arrived.");
    }
    if (!isGray(E)) row(ui, "E in R, G, B", shown(E), palette.estimate, "The same, colour by colour.");
    if (answer.corrected)
        row(ui, "E corrected", shown(gray(answer.corrected->total())), palette.normal,
            "The same run, the same random numbers, by the corrected castRay.");
}

/// What the strip, of more passes, shows there.
void stripRow(const Ui& ui, const LightAnswer& answer, std::uint32_t pixel) {
    const LightPicture* strip = answer.pictures.eye.get();
    if (!strip || strip->film.passes == 0 || pixel >= strip->film.pixels.size()) return;
    const Statistics value = strip->film.pixels[pixel];
    const double error = gray(value.standardError());
    row(ui, "in the strip",
        fmt::format("{} \u00b1 {}", shown(gray(value.mean)), shownError(error, gray(value.mean))),
        ui.palette.exact,
        say("The same pixel as the strip shows it, of {} passes, W/(m rad).", strip->film.passes));
}

/// The same of another estimator's run.
void pathRunRows(const Ui& ui, const LightAnswer& answer) {
    const PathRun& run = *answer.pathRun;
    const auto pixel = pixelOf(answer);
    const std::string name = pixel ? say("L of pixel {}", *pixel) : std::string("estimate of E");
    if (!run.refusal.empty()) return row(ui, name, "none", ui.palette.error, trMessage(run.refusal));
    std::string value = shown(gray(run.estimate));
    if (run.standardError)
        value += fmt::format(" \u00b1 {}", shownError(gray(*run.standardError), gray(run.estimate)));
    if (pixel)
        row(ui, name, value, ui.palette.estimate,
            "What the N paths of this run say the pixel sees (radiance, W/(m rad)), plus or minus one "
            "standard "
            "error where they are independent. Of a coloured light, the mean of red, green and blue.");
    else
        row(ui, name, value, ui.palette.estimate,
            "What the N paths of this run say arrives at P (irradiance, W/m), plus or minus one standard "
            "error "
            "where they are independent. Of a coloured light, the mean of red, green and blue.");
    if (pixel)
        stripRow(ui, answer, *pixel);
    else if (ui.state.shows(View::exact) && answer.exact && gray(*answer.exact) != 0.0)
        row(ui, "off by",
            local(fmt::format("{:+.1f} %", 100.0 * (gray(run.estimate) / gray(*answer.exact) - 1.0))),
            ui.palette.ink, "Estimate against exact value.");
    row(ui, "rays cast", withThousands(run.counts.rays), ui.palette.ink,
        "All rays of this one run, shadow rays included.");
    if (run.counts.nonFinite > 0)
        row(ui, "samples not finite", withThousands(run.counts.nonFinite), ui.palette.error,
            "Contributions that are infinite or not a number. They are left out, and should not exist.");
    if (run.record.truncated && ui.state.playback.stepping)
        row(ui, "record", "later paths left out", ui.palette.error,
            "The run has too many steps to keep them all.");
}

void exactRow(const Ui& ui, const LightAnswer& answer) {
    const bool searching = !answer.exact && !answer.pointComplete;
    const std::string value = answer.exact ? shown(gray(*answer.exact)) : searching ? "\u2026" : "not known";
    row(ui, "exact E", value, ui.palette.exact,
        "The integral itself, by quadrature between the edges of what P sees (W/m). Nothing random in it. "
        "Known for diffuse rooms only, with not too many walls.");
}

void costRows(const Ui& ui, const LightAnswer& answer) {
    const Palette& palette = ui.palette;
    if (ui.state.shows(View::exact) && answer.exact && gray(*answer.exact) != 0.0)
        row(ui, "off by",
            local(fmt::format("{:+.1f} %",
                              100.0 * (gray(answer.estimate.total()) / gray(*answer.exact) - 1.0))),
            palette.ink, "Estimate against exact value.");
    row(ui, "L of the wall", answer.radiance ? shown(*answer.radiance) : "depends on the view", palette.ink,
        "The radiance that P's wall sends out: its emission plus albedo / 2 times E, in W/(m rad). Of a wall "
        "that is not diffuse it differs with the direction.");
    row(ui, "rays cast", withThousands(answer.rays), palette.ink,
        "Half-disk rays at all depths and shadow rays, in this one run.");
}

/// P where no light can be, for a wall that was written first takes it.
void coverRow(const Ui& ui, const LightAnswer& answer) {
    const PreparedScene& scene = *answer.asked.scene;
    const std::uint32_t over = wallOver(scene.index, answer.point);
    if (over == kNoSegment) return;
    row(ui, "P lies behind", quotedName(scene.scene, over), ui.palette.error,
        "Of two walls in the same place only the one that was written first is met. What is behind it "
        "receives nothing.");
}

}  // namespace

void numbersPanel(const Ui& ui) {
    const AppState& state = ui.state;
    const Palette& palette = ui.palette;
    if (!state.answer) return row(ui, "estimate of E", "\u2026", palette.estimate, "");
    const LightAnswer& answer = *state.answer;
    if (answer.pathRun) {
        const auto pixel = pixelOf(answer);
        if (state.shows(View::exact) && !pixel) exactRow(ui, answer);
        if (!state.shows(View::numbers)) return;
        if (runIsFinished(state)) return pathRunRows(ui, answer);
        return row(ui, pixel ? say("L of pixel {}", *pixel) : std::string("estimate of E"),
                   say("step {} of {}", state.playback.event, state.eventCount()), palette.estimate,
                   "The run is not finished yet: step on, or press End.");
    }
    if (answer.tooManyRays) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette.error);
        textWrapped(ui.widgets,
                    say("One run would cast {:.3g} rays: N rays at P, N from each of their ends, and so on, "
                        "N^(maxDepth+1) in all. Lower N or maxDepth.",
                        static_cast<double>(answer.rays)));
        ImGui::PopStyleColor();
        return;
    }
    coverRow(ui, answer);
    const bool numbers = state.shows(View::numbers), finished = runIsFinished(state);
    if (numbers && finished) estimateRows(ui, answer);
    if (numbers && !finished)
        row(ui, "estimate of E", say("step {} of {}", state.playback.event, state.eventCount()),
            palette.estimate, "The run is not finished yet: step on, or press End.");
    if (state.shows(View::exact)) exactRow(ui, answer);
    if (numbers && finished) costRows(ui, answer);
    if (answer.nonFinite > 0)
        row(ui, "samples not finite", withThousands(answer.nonFinite), palette.error,
            "Samples that are infinite or not a number. They are left out of the mean, and should not "
            "exist.");
    if (answer.record && answer.record->truncated && state.playback.stepping)
        row(ui, "record", "deeper steps left out", palette.error,
            "The run has too many steps to keep them all.");
}

}  // namespace halfdisk
