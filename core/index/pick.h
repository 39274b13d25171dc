// How is one of two values taken without a branch? Compilers make branches of ?: as they see fit; where it is
// a matter of chance which way it goes, half of them are guessed wrong, at 20 cycles each.
#pragma once

#include <cstdint>

namespace halfdisk {
namespace {

inline std::uint32_t pick(bool first, std::uint32_t a, std::uint32_t b) {
    return b ^ ((a ^ b) & (0u - static_cast<std::uint32_t>(first)));
}

inline std::int32_t pick(bool first, std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(
        pick(first, static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)));
}

inline float pick(bool first, float a, float b) {
    return __builtin_bit_cast(
        float, pick(first, __builtin_bit_cast(std::uint32_t, a), __builtin_bit_cast(std::uint32_t, b)));
}

inline double pick(bool first, double a, double b) {
    const auto x = __builtin_bit_cast(std::uint64_t, a), y = __builtin_bit_cast(std::uint64_t, b);
    return __builtin_bit_cast(double, y ^ ((x ^ y) & (0u - static_cast<std::uint64_t>(first))));
}

}  // namespace
}  // namespace halfdisk
