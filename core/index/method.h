// By which way are walls found, and by which instructions?
#pragma once

#include "core/index/kernels.h"
#include "core/precision.h"

namespace halfdisk {

/// All give the same hits, to the bit; but `single`, whose hits are off by what float rounds. It is there to
/// measure that, and never taken by itself. Files keep the numbers.
enum class IndexMethod : std::uint8_t { automatic, everyWall, bruteForce, tree, grid, single };

inline constexpr std::array<Named<IndexMethod>, 6> kIndexMethods{{
    {IndexMethod::automatic, "automatic", "what is fastest for so many walls"},
    {IndexMethod::everyWall, "every wall", "each wall in double precision, one after the other"},
    {IndexMethod::bruteForce, "brute force",
     "each wall in single precision, several at a time; those that may be met in double"},
    {IndexMethod::tree, "tree", "the same, but only walls in boxes that the ray enters"},
    {IndexMethod::grid, "grid", "the same, but only walls in cells that the ray goes through"},
    {IndexMethod::single, "single",
     "each wall in single precision alone, several at a time: as a tracer in float would"},
}};

/// In which it is decided what a ray meets.
constexpr Precision precisionOf(IndexMethod method) {
    return method == IndexMethod::single ? Precision::single : Precision::twice;
}

inline constexpr std::array<Named<InstructionSet>, 3> kInstructionSets{{
    {InstructionSet::baseline, "baseline", "4 walls at a time"},
    {InstructionSet::avx2, "AVX2", "8 walls at a time"},
    {InstructionSet::avx512, "AVX-512", "16 walls at a time"},
}};

}  // namespace halfdisk
