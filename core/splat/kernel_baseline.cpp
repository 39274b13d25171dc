// The kernel for every processor.
#include "core/splat/kernel.h"
#include "core/splat/kernels.h"

namespace halfdisk {

void drawRunsBaseline(const SplatBand& band, FlightRun* runs, std::size_t count) {
    drawRuns(band, runs, count);
}

}  // namespace halfdisk
