// How do the plots of a trade get into files? Drawn as in the window, without one.
#include "app/trade_plots.h"

#include <fmt/format.h>

#include "app/cli_output.h"
#include "app/headless_host.h"
#include "app/png_image.h"
#include "app/sheet.h"
#include "app/trade_drawing.h"
#include "lessons/atomic_file.h"

namespace halfdisk {
namespace {

constexpr int kWidth = 1200, kHeight = 820;
constexpr float kScale = 1.25f, kMargin = 16.0f;

using Drawer = std::function<void(const Ui&, ImVec2)>;

/// A host with pixels where there is OpenGL; else one without.
std::unique_ptr<HeadlessHost> anyHost(bool& pixels) {
    try {
        auto host = std::make_unique<HeadlessHost>(kWidth, kHeight, kScale);
        pixels = true;
        return host;
    } catch (const std::runtime_error& error) {
        writeError(fmt::format("{}: the plots are written as SVG only", error.what()));
        pixels = false;
        return HeadlessHost::withoutGl(kWidth, kHeight, kScale);
    }
}

/// The whole picture is one plot.
void drawAlone(Session& session, const Fonts& fonts, Sheet* sheet, const char* name, const Drawer& draw) {
    session.widgets = {};
    Commands none;
    const Ui ui{session.state,     fonts,           session.palette,
                session.listings,  session.widgets, none,
                session.languages, kScale,          sheet};
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({kWidth, kHeight});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kMargin, kMargin});
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
    {
        const OnSheet sheeted(ui, name, ImVec2{0, 0}, ImVec2{kWidth, kHeight});
        draw(ui, ImGui::GetContentRegionAvail());
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

std::string wordsOf(const TradeReport& report) {
    std::string words;
    for (const auto& cost : kTradeCosts)
        for (const TradeStretch& stretch : report.fronts[at(cost.value)])
            words += fmt::format("By {}, for an error of {:.3g} % to {:.3g} % the cheapest is {}.\n",
                                 cost.name, 100.0 * stretch.fromError, 100.0 * stretch.toError,
                                 report.cells[stretch.cell].name);
    return words;
}

}  // namespace

std::vector<std::string> writeTradePlots(const std::filesystem::path& folder, const TradeReport& report) {
    struct TradePlot {
        const char* name;
        const char* title;
        Drawer draw;
    };
    const std::vector<TradePlot> pictures{
        {"front", "What accuracy costs, in rays",
         [&](const Ui& ui, ImVec2 size) { drawTradeFront(ui, report, TradeCost::rays, size); }},
        {"front-seconds", "What accuracy costs, in seconds",
         [&](const Ui& ui, ImVec2 size) { drawTradeFront(ui, report, TradeCost::seconds, size); }},
        {"convergence", "How the error falls",
         [&](const Ui& ui, ImVec2 size) { drawConvergence(ui, report, size); }}};
    if (report.truth.isDark()) return {};  // there is no error to draw
    bool pixels = false;
    const std::unique_ptr<HeadlessHost> host = anyHost(pixels);
    Session session;
    session.state.uiScale = kScale;
    std::vector<std::string> names;
    for (const TradePlot& picture : pictures) {
        Sheet sheet;
        const auto draw = [&](Sheet* to) {
            return [&session, &host, &picture, to] {
                drawAlone(session, host->fonts(), to, picture.name, picture.draw);
            };
        };
        host->frameWithoutDrawing(draw(nullptr));
        host->frameWithoutDrawing(draw(&sheet));
        const SvgDrawing* drawing = sheet.find(picture.name);
        names.push_back(fmt::format("{}.svg", picture.name));
        if (drawing) writeFileAtomically(folder / names.back(), drawing->svg(picture.title, wordsOf(report)));
        if (!pixels) continue;
        host->frame(draw(nullptr));
        names.push_back(fmt::format("{}.png", picture.name));
        writePng(folder / names.back(), host->readPixels());
    }
    return names;
}

}  // namespace halfdisk
