// What can be shown at once of a picture whose estimator takes long to prepare? The same, but coarse.
#pragma once

#include <optional>

#include "core/sensor.h"
#include "lessons/maker.h"

namespace halfdisk {

/// `maker` with the parameters that its estimator names for a first look (ParamInfo::firstLook), where they
/// are less than asked for; nothing if there are none.
std::optional<Maker> firstLookOf(const Maker& maker);

/// A field with a quarter of the columns and rows; every other sensor as it is.
Sensor coarse(const Sensor& sensor);

}  // namespace halfdisk
