// The tables that were built: what kernels.cpp chooses from.
#pragma once

#include "core/index/kernels.h"

namespace halfdisk {

extern const Kernels kBaselineKernels;
#ifdef HALFDISK_X86
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;
#endif

}  // namespace halfdisk
