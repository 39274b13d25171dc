// Which scenes can there be? Any mixture of lights and materials, closed or open, by a seed.
#pragma once

#include "core/scene.h"

namespace halfdisk::test {

/// Walls face each other across a place of about 3 m by 2 m. Segment 0 is a floor that scatters; there is
/// always light. Mirrors, glass, lobes, delta lights, lamps and the environment each come and go.
Scene randomScene(std::uint64_t seed);

}  // namespace halfdisk::test
