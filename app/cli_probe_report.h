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

}  // namespace halfdisk
