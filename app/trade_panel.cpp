#include "app/panels.h"
#include "app/plot.h"
#include "app/plot_words.h"

namespace halfdisk {

void tradePanel(const Ui& ui, ImVec2 size) {
    beginPlot(ui, "trade", drawingTitle(ui.state, "trade"), size, {}, {});
}

}  // namespace halfdisk
