// How much light is cut off where paths are cut short? The same paths are followed further, with the same
// random numbers, so that the difference is what the further events bring.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

/// Light beyond the deepest paths that were followed.
struct Tail {
    double light = 0.0;  ///< in the units of Pilot::mean
    double standardError = 0.0;
};

/// Of the totals of two runs with the same passes.
struct Difference {
    double mean = 0.0, standardError = 0.0;
};

Difference differenceOf(const Pilot& all, const Pilot& upTo);

/// As if what each third of the depth brings went on to fall as the last two do, but by no less than
/// `mostRatio`: what walls may keep over a third. The three runs have the same passes.
Tail tailOf(const Pilot& all, const Pilot& twoThirds, const Pilot& third, double mostRatio);

/// Where light comes by mirrors or glass, the way that knows it best after a short run, for paths may hardly
/// ever meet it; with more rays where it is rare all the same. Nothing if no way finds all light. `rays` is
/// added to.
std::optional<Series> seriesOf(const RequirementsQuestion& question, const SceneTraits& traits,
                               std::uint64_t& rays);

/// Its deepest run.
Pilot deepestRun(const RequirementsQuestion& question, const Series& series, std::uint64_t& rays);

/// Of the light of `all` and beyond, what is not in `upTo`, which has the same passes, cut after so many
/// events.
BeyondDepth shareBeyond(std::uint32_t events, const Pilot& all, const Pilot& upTo, const Tail& tail = {});

/// `0.44 % (± 0.23 %) of the light`, and, where that is what decided, what it was taken for.
std::string shareWords(const BeyondDepth& beyond, double tolerance);

/// That light is missing, or may be, where it is not enough.
std::string_view lackWords(const BeyondDepth& beyond, double tolerance);

}  // namespace halfdisk
