// How many mirror and glass events in a row must be followed? By geometry, or else by a measurement, from
// where mirrors have swallowed nearly all.
#pragma once

#include "core/requirements/requirements.h"
#include "core/requirements/series.h"

namespace halfdisk {

/// `rays` is added to. Throws Stopped.
SpecularFindings findSpecular(const RequirementsQuestion& question, const SceneFacts& facts,
                              const std::optional<Series>& series, std::uint64_t& rays);

/// Light of chains that are longer than those of `all`. As bright, path by path, as what ended between `half`
/// and there: of paths that were cut at half the events, and no longer are in `all`, it is known what they
/// bring. The two runs have the same passes.
Tail endlessChains(const Pilot& all, const Pilot& half);

/// Of all light, what more than so many events bring; nothing where geometry says that there are no more, or
/// no way finds all light. `rays` is added to. Throws Stopped.
std::optional<BeyondDepth> beyondEvents(const RequirementsQuestion& question,
                                        const SpecularFindings& specular, const std::optional<Series>& series,
                                        std::uint32_t events, std::uint64_t& rays);

/// What is left out by it, as measured, half of the tolerance at most: so much less may the bounces leave
/// out.
double specularShare(const SpecularFindings& specular, double tolerance);

/// Why so many, with all numbers.
std::string specularReason(const RequirementsAnswer& answer);

}  // namespace halfdisk
