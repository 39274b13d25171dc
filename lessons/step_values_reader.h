// How do the keys of [defaults], [step.set] and of a claim's measurements become values?
#pragma once

#include <fmt/format.h>

#include "lessons/lesson.h"
#include "lessons/table_reader.h"
#include "lessons/value_reader.h"

namespace halfdisk {

/// An array of names of a closed set, each at most once.
template <class Set, class Enum, std::size_t Count>
void readSet(const std::string& file, std::string_view key, const TomlValue& value, std::string_view expected,
             const std::array<Named<Enum>, Count>& names, Set& set) {
    for (const TomlValue& element : readArray(file, key, value, expected)) {
        const Enum member = readNamed(file, key, element, names);
        if (set.has(member))
            failAt(file, element.where,
                   fmt::format("\"{}\" lists \"{}\" twice, expected it once", key, nameOf(names, member)));
        set.set(member, true);
    }
}

/// What numbers may be: as large as a step can show while it is touched, or as large as a measurement may
/// take.
struct StepLimits {
    std::uint64_t samples, depth;
};

/// Replaces what the table has: samples, depth, seed, sampler, emitters, at (of `scene`), asPrinted. Does not
/// finish the table.
void readSettings(TableReader& table, const Scene& scene, const StepLimits& limits, Settings& settings,
                  WallPoint& at);

}  // namespace halfdisk
