// Which way of carrying light takes the fewest rays? Those that carry all of it and do what is forced are
// tried on the scene, shortly.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

/// What is forced of a requirement, if anything.
std::optional<std::uint32_t> forcedTo(const RequirementsQuestion& question, RequirementId id);

/// Whether a way asks lights: those without size can't be met, so whoever looks back must.
bool asksLights(const Way& way, const SceneTraits& traits);

/// Adds candidates to the answer and takes the best of them as its plan, whose depth, events and index are
/// there already: of the complete ways without bias the one that takes the fewest rays; else of those with a
/// bias; else of what is left. `small`: the sensor on which they are tried. Throws std::invalid_argument if
/// no way does what is forced, and Stopped.
void searchWay(const RequirementsQuestion& question, const Sensor& small, RequirementsAnswer& answer);

/// Of all the time, what passes before the search: the bounces.
inline constexpr double kBounceShare = 0.3;

}  // namespace halfdisk
