// The kernel for processors with AVX2; CMakeLists.txt gives this file its flag.
#include "core/splat/kernel.h"
#include "core/splat/kernels.h"

namespace halfdisk {

void drawRunsAvx2(const SplatBand& band, FlightRun* runs, std::size_t count) {
    drawRuns(band, runs, count);
}

}  // namespace halfdisk
