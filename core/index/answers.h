// What does a kernel answer? The methods of SegmentIndex, for one instruction set.
#pragma once

#include "core/index/fan.h"
#include "core/index/kernels.h"
#include "core/index/occlusion.h"

namespace halfdisk {
namespace {

constexpr Kernels tableOf(InstructionSet instructions) {
    return {instructions, closestOfAll, occludedByAny, closestHit, occluded, closestHits, closestHitsFan};
}

}  // namespace
}  // namespace halfdisk
