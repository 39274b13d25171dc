// The kernels of one instruction set; CMakeLists.txt gives this file its flags.
#include "core/index/answers.h"
#include "core/index/kernel_tables.h"

namespace halfdisk {

const Kernels kBaselineKernels = tableOf(InstructionSet::baseline);
const Kernels kBaselineSingleKernels = singleTableOf(InstructionSet::baseline);

}  // namespace halfdisk
