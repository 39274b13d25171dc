// The kernels of one instruction set; CMakeLists.txt gives this file its flags.
#include "core/index/answers.h"
#include "core/index/kernel_tables.h"

namespace halfdisk {

const Kernels kAvx2Kernels = tableOf(InstructionSet::avx2);
const Kernels kAvx2SingleKernels = singleTableOf(InstructionSet::avx2);

}  // namespace halfdisk
