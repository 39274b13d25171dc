#include "app/seen.h"

#include "app/input_events.h"
#include "app/plot_tables.h"

namespace halfdisk {
namespace {

// Dear ImGui sizes some windows by what they held in the frame before: a few frames until nothing moves.
constexpr int kSettleFrames = 4;

/// Whether something is shown that the sheet lacks. A field belongs to the canvas.
bool lacksSome(const AppState& state, const Sheet& sheet) {
    if (!sheet.find("canvas")) return true;
    for (const PlotTable& plot : kPlotTables)
        if (state.shows(plot.view) && plot.view != View::field && !sheet.find(plot.name)) return true;
    return false;
}

/// What a picture leaves out, and what the frames below change, put back at the end.
class Undisturbed {
 public:
    explicit Undisturbed(AppState& state)
        : state_(state),
          helpShown_(state.helpShown),
          exportWished_(state.exportWished),
          canvasHidden_(state.canvasHidden),
          editing_(state.editing.on),
          fitCamera_(state.fitCamera),
          playing_(state.playback.playing),
          pane_(state.pane),
          camera_(state.camera),
          eyePixel_(state.eyePixel),
          banner_(std::move(state.banner)),
          notice_(std::move(state.notice)) {
        state.helpShown = state.exportWished = state.playback.playing = false;
        state.banner.clear();
        state.notice.clear();
    }
    ~Undisturbed() {
        state_.helpShown = helpShown_;
        state_.exportWished = exportWished_;
        state_.canvasHidden = canvasHidden_;
        state_.editing.on = editing_;
        state_.fitCamera = fitCamera_;
        state_.playback.playing = playing_;
        state_.pane = pane_;
        state_.camera = camera_;
        state_.eyePixel = eyePixel_;
        if (state_.banner.empty()) state_.banner = std::move(banner_);
        state_.notice = std::move(notice_);
    }
    Undisturbed(const Undisturbed&) = delete;
    Undisturbed& operator=(const Undisturbed&) = delete;

 private:
    AppState& state_;
    bool helpShown_, exportWished_, canvasHidden_, editing_, fitCamera_, playing_;
    Pane pane_;
    Camera camera_;
    std::optional<std::uint32_t> eyePixel_;
    std::string banner_, notice_;
};

}  // namespace

Seen seenBy(Session& session, const FrameMaker& maker) {
    AppState& state = session.state;
    const Undisturbed undisturbed(state);
    Seen seen;
    const auto drawOn = [&](Sheet* sheet) {
        return [&session, &maker, sheet] {
            const PointerAway away(ImGui::GetIO());
            frame(session, maker.fonts(), maker.scale(), sheet);
        };
    };
    const auto settle = [&] {
        for (int i = 0; i < kSettleFrames; ++i) maker.layOut(drawOn(nullptr));
    };
    settle();
    maker.draw(drawOn(&seen.sheet));
    seen.screen = maker.pixels();
    // Small screens, and the editor, hide some: look everywhere.
    constexpr std::pair<Pane, bool> kArrangements[] = {
        {Pane::stage, false}, {Pane::controls, false}, {Pane::stage, true}};
    for (const auto& [pane, canvasHidden] : kArrangements) {
        if (!lacksSome(state, seen.sheet)) break;
        state.pane = pane;
        state.canvasHidden = canvasHidden;
        state.editing.on = false;
        settle();
        maker.layOut(drawOn(&seen.sheet));
    }
    return seen;
}

}  // namespace halfdisk
