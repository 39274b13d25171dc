// The kernels of one instruction set; CMakeLists.txt gives this file its flags.
#include "core/index/answers.h"
#include "core/index/kernel_tables.h"

namespace halfdisk {

const Kernels kAvx512Kernels = tableOf(InstructionSet::avx512);
const Kernels kAvx512SingleKernels = singleTableOf(InstructionSet::avx512);

}  // namespace halfdisk
