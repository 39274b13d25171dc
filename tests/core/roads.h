// What do the tests of all roads of light share? Scenes written as code, and values good to half a percent.
#pragma once

#include "agreement.h"
#include "rooms.h"
#include "sweep.h"

namespace halfdisk::test {

/// Names walls and materials that have no name. Without its index: see prepare.
Stage staged(const std::string& name, Scene scene);

/// Makes the index, which keeps a pointer to the stage's scene: the stage must stay where it is.
void prepare(Stage& stage);

/// The relative standard error that is asked of a value.
inline constexpr double kPrecision = 0.005;

/// A small run tells how many samples pixel 0 needs for kPrecision in all channels; then the run itself.
Film measureWell(const Stage& stage, const Sensor& sensor, Run run);

/// Four times the samples of `first`, a film of `run`, from other random numbers.
Film measureAgain(const Stage& stage, const Sensor& sensor, Run run, const Film& first);

/// The first channel of a pixel against the truth: within 3.5 standard errors, these within `precision`, and
/// five percent more is told.
void checkValue(const Film& film, std::size_t pixel, double exact, double err, double precision = kPrecision);

}  // namespace halfdisk::test
