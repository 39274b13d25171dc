// How does a result reach the reader, or a script? One way out for every command.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/math.h"

namespace halfdisk {

using Json = nlohmann::ordered_json;

/// Writes to stdout and flushes. Throws std::runtime_error if the bytes do not get out: a full disk, a closed
/// pipe.
void writeOutput(std::string_view text);

/// One object on one line.
void writeJson(const Json& object);

/// `halfdisk: message` on stderr. A message that starts with a file's name stands alone, as editors expect
/// it.
void writeError(std::string_view message, bool startsWithFile = false);

/// A number, or null where it is not finite: JSON knows no NaN. No negative zero.
Json jsonOf(double value);
Json jsonOf(Vec2 value);        ///< [x, y]
Json jsonOf(const Rgb& value);  ///< [r, g, b]

}  // namespace halfdisk
