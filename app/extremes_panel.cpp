#include "app/panels.h"
#include "app/plot.h"
#include "app/plot_words.h"

namespace halfdisk {

void extremesPanel(const Ui& ui, ImVec2 size) {
    beginPlot(ui, "extremes", drawingTitle(ui.state, "extremes"), size, {}, {});
}

}  // namespace halfdisk
