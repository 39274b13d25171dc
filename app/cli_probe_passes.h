// What does an estimator of the registry answer to a probe? Passes at one point, or along one ray.
#pragma once

#include <functional>
#include <vector>

#include "app/cli_output.h"
#include "app/cli_probe.h"
#include "app/measurement.h"

namespace halfdisk {

struct PassesAnswer {
    ProbeQuestion question;
    ProbePlace place;
    Measurement measurement;
    MeasuredRgb light;                    ///< irradiance (W/m), or of a look radiance (W/(m rad))
    std::optional<MeasuredRgb> radiance;  ///< of the wall itself, scattered once more
    std::vector<Rgb> values;              ///< of each pass, if they were asked for
    std::optional<Rgb> exact;             ///< of E, where it is known
};

/// Ends early by a signal, maybe without a single pass. Throws InputError if the estimator refuses.
PassesAnswer probeByPasses(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place);

/// The object that scripts rely on: the keys of probeJson that it has, then its own.
Json passesJson(const PassesAnswer& answer);

/// A table with units.
std::string passesTable(const PassesAnswer& answer);

}  // namespace halfdisk
