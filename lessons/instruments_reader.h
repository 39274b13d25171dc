// How does a lesson set the instruments? The keys of [step.set] that are theirs.
#pragma once

#include "lessons/instruments.h"
#include "lessons/table_reader.h"

namespace halfdisk {

/// The requirement of that name; null if there is none, or none that can be switched: then `fault` tells, to
/// stand behind the name.
const RequirementInfo* findSwitch(std::string_view name, std::string& fault);

/// Replaces what the inline table `dial` has.
void readDial(const std::string& file, const TomlValue& value, DialSetting& dial);

/// Replaces all by the inline table `force`: of requirements that can be switched, true, false or a number.
void readForced(const std::string& file, const TomlValue& value, std::vector<Forced>& forced);

/// Replaces what the table has: dial = { scale, offset, gap, precision, policy, epsilon }, wishedError or
/// wishedMilliseconds, tradeCost, tolerance, force. Does not finish the table.
void readInstruments(TableReader& table, InstrumentSettings& settings);

}  // namespace halfdisk
