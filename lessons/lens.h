// How do two curvatures, a height and a thickness become a lens, and when can there be none?
#pragma once

#include <cstdint>
#include <vector>

#include "lessons/shape_edges.h"

namespace halfdisk {

/// Thickness at the rim (m); below 0 the surfaces cross. Each radius is 0 or at least half the height.
double rimThickness(const LensShape& lens);

/// False if the surfaces meet at the rim: its thickness is within a billionth of the height of 0.
bool hasRim(const LensShape& lens);

/// True if the facets of the surfaces, rather than the surfaces, meet or cross off the rim: a thin, bent lens
/// of few facets. Expands the lens.
bool facetsCross(const LensShape& lens);

/// edgeCount and edgesOf for a lens; the order of the edges is told at LensShape.
std::uint64_t lensEdgeCount(const LensShape& lens);
std::vector<Edge> lensEdges(const LensShape& lens);

}  // namespace halfdisk
