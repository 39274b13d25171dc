#include "app/fingerprint.h"

#include <fmt/format.h>

#include <cstdint>

namespace halfdisk {

std::string fingerprintOf(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

}  // namespace halfdisk
