#include "app/panels.h"
#include "app/plot.h"
#include "app/plot_words.h"

namespace halfdisk {

void requirementsPanel(const Ui& ui, ImVec2 size) {
    beginPlot(ui, "requirements", drawingTitle(ui.state, "requirements"), size, {}, {});
}

}  // namespace halfdisk
