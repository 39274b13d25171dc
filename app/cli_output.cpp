#include "app/cli_output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace halfdisk {

void writeOutput(std::string_view text) {
    const bool written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!written)
        throw std::runtime_error(fmt::format("the output cannot be written: {}", std::strerror(errno)));
}

void writeJson(const Json& object) {
    // A file name need not be UTF-8; JSON must be.
    writeOutput(object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void writeError(std::string_view message, bool startsWithFile) {
    const std::string line = fmt::format("{}{}\n", startsWithFile ? "" : "halfdisk: ", message);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

Json jsonOf(double value) {
    if (!std::isfinite(value)) return nullptr;
    return value + 0.0;
}

Json jsonOf(Vec2 value) {
    return Json::array({jsonOf(value.x), jsonOf(value.y)});
}

Json jsonOf(const Rgb& value) {
    return Json::array({jsonOf(value.x), jsonOf(value.y), jsonOf(value.z)});
}

}  // namespace halfdisk
