// The kernels that were built: what the processor's is chosen from.
#pragma once

#include "core/splat/flight_run.h"

namespace halfdisk {

void drawRunsBaseline(const SplatBand& band, FlightRun* runs, std::size_t count);
#ifdef HALFDISK_X86
void drawRunsAvx2(const SplatBand& band, FlightRun* runs, std::size_t count);
#endif

}  // namespace halfdisk
