#include "core/index/kernels.h"

#include "core/index/kernel_tables.h"

namespace halfdisk {

bool isSupported(InstructionSet instructions) {
#ifdef HALFDISK_X86
    switch (instructions) {
        case InstructionSet::baseline:
            return true;
        case InstructionSet::avx2:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
        case InstructionSet::avx512:
            return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    }
    return false;
#else
    return instructions == InstructionSet::baseline;
#endif
}

const Kernels* kernelsOf(InstructionSet instructions) {
#ifdef HALFDISK_X86
    if (instructions == InstructionSet::avx2) return &kAvx2Kernels;
    if (instructions == InstructionSet::avx512) return &kAvx512Kernels;
#endif
    return instructions == InstructionSet::baseline ? &kBaselineKernels : nullptr;
}

const Kernels& singleKernels(const Kernels& kernels) {
#ifdef HALFDISK_X86
    if (kernels.instructions == InstructionSet::avx2) return kAvx2SingleKernels;
    if (kernels.instructions == InstructionSet::avx512) return kAvx512SingleKernels;
#endif
    return kBaselineSingleKernels;
}

const Kernels& bestKernels() {
    for (const InstructionSet best : {InstructionSet::avx512, InstructionSet::avx2})
        if (isSupported(best)) return *kernelsOf(best);
    return kBaselineKernels;
}

}  // namespace halfdisk
