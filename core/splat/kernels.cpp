// Which kernel does this processor take?
#include "core/splat/kernels.h"

#include "core/index/kernels.h"

namespace halfdisk {

SplatKernel bestSplatKernel() {
#ifdef HALFDISK_X86
    if (isSupported(InstructionSet::avx2)) return drawRunsAvx2;
#endif
    return drawRunsBaseline;
}

}  // namespace halfdisk
