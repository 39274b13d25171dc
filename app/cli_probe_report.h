// How is the answer of a probe told, to a script and to a student?
#pragma once

#include <string>

#include "app/cli_output.h"
#include "app/cli_probe.h"

namespace halfdisk {

/// The object that scripts rely on; its keys keep their order, more may come at the end.
Json probeJson(const ProbeAnswer& answer);

/// A table with units, and warnings where samples were bad.
std::string probeTable(const ProbeAnswer& answer);

/// A line of a table: symbol, meaning, unit, three numbers; `-` for NaN.
std::string probeRow(std::string_view symbol, std::string_view meaning, std::string_view unit,
                     const Rgb& value);

/// The mean, and below it its standard error where it is known.
std::string probeRows(std::string_view symbol, std::string_view meaning, std::string_view unit,
                      const MeasuredRgb& measured);

/// The exact E and how many standard errors away `measured` is; nothing where it is not known.
std::string exactRows(const MeasuredRgb& measured, const std::optional<Rgb>& exact);

/// {mean, standardError}
Json measuredJson(const MeasuredRgb& measured);

Json jsonOrNull(const std::optional<Rgb>& value);

}  // namespace halfdisk
