// Which code answers a ray? One table of functions for each instruction set; the best that the processor has
// is taken once.
#pragma once

#include <span>

#include "core/index/layout.h"
#include "core/ray.h"

namespace halfdisk {

enum class InstructionSet : std::uint8_t { baseline, avx2, avx512 };

struct Kernels {
    InstructionSet instructions;
    Hit (*closestOfAll)(const IndexView&, const Ray&);  // these two in double precision alone
    bool (*occludedByAny)(const IndexView&, const Ray&, double tMax, std::uint32_t lamp);
    Hit (*closestHit)(const IndexView&, const Ray&);
    bool (*occluded)(const IndexView&, const Ray&, double tMax, std::uint32_t lamp);
    void (*closestHits)(const IndexView&, const Ray*, Hit*, std::size_t);
    void (*closestHitsFan)(const IndexView&, const Ray*, Hit*, std::size_t);
};

/// Of an instruction set that the processor may lack; null if it was not built.
const Kernels* kernelsOf(InstructionSet instructions);
bool isSupported(InstructionSet instructions);
const Kernels& bestKernels();
/// The table whose answers are in single precision alone, by the same instructions.
const Kernels& singleKernels(const Kernels& kernels);

}  // namespace halfdisk
