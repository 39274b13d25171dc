// The tables that were built: what kernels.cpp chooses from.
#pragma once

#include "core/index/kernels.h"

namespace halfdisk {

extern const Kernels kBaselineKernels, kBaselineSingleKernels;
#ifdef HALFDISK_X86
extern const Kernels kAvx2Kernels, kAvx2SingleKernels;
extern const Kernels kAvx512Kernels, kAvx512SingleKernels;
#endif

}  // namespace halfdisk
