// How are the random numbers of four samples drawn at once? The same bits as Random123's Philox4x32-10, two
// samples in each vector: where many rays are cast, that is a quarter of the time.
#pragma once

#include <array>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace halfdisk {

/// One value for each of two samples. What is meant is the lower half of each; the upper may hold anything.
using PhiloxPair [[gnu::vector_size(16)]] = std::uint64_t;

/// The product of the lower halves, all 64 bits of it.
inline PhiloxPair wideProduct(PhiloxPair a, std::uint32_t b) {
#if defined(__SSE2__)
    return reinterpret_cast<PhiloxPair>(
        _mm_mul_epu32(reinterpret_cast<__m128i>(a), _mm_set1_epi64x(static_cast<long long>(b))));
#else
    return (a & 0xFFFFFFFF) * b;
#endif
}

struct PhiloxKey {
    std::uint32_t low, high;
};

/// Two counters side by side: their four words.
struct PhiloxPairs {
    PhiloxPair word[4];

    /// Salmon et al. 2011, section 3.2 and figure 2: what ten rounds make of the counters.
    [[gnu::always_inline]] void encrypt(PhiloxKey key) {
        for (int round = 0; round < 10; ++round) {
            const PhiloxPair even = wideProduct(word[0], 0xD2511F53), odd = wideProduct(word[2], 0xCD9E8D57);
            word[0] = (odd >> 32) ^ word[1] ^ key.low;
            word[1] = odd;
            word[2] = (even >> 32) ^ word[3] ^ key.high;
            word[3] = even;
            key.low += 0x9E3779B9;
            key.high += 0xBB67AE85;
        }
    }

    /// The first or the second 64 bits, as a double in (0, 1).
    [[gnu::always_inline]] void toUnit(unsigned half, double* two) const {
        constexpr std::uint64_t kLower = 0xFFFFFFFF, kOne = 0x3FF0000000000000;
        const PhiloxPair bits = (word[2 * half] << 32) | (word[2 * half + 1] & kLower);
        using Doubles [[gnu::vector_size(16)]] = double;
        // Behind the exponent of 1 the 52 bits make a number in [1, 2).
        const Doubles unit = reinterpret_cast<Doubles>((bits >> 12) | kOne) - 1.0 + 0x1p-53;
        two[0] = unit[0];
        two[1] = unit[1];
    }
};

/// Of the counters (low, high, first ... first + 3, block) one half each.
inline std::array<double, 4> philoxRow(PhiloxKey key, std::uint64_t node, std::uint32_t first,
                                       std::uint32_t block, unsigned half) {
    const PhiloxPair none{};
    std::array<double, 4> values;
    for (std::uint32_t two = 0; two < 4; two += 2) {
        PhiloxPairs pairs{{none + (node & 0xFFFFFFFF), none + (node >> 32),
                           PhiloxPair{first + two, first + two + 1}, none + std::uint64_t{block}}};
        pairs.encrypt(key);
        pairs.toUnit(half, values.data() + two);
    }
    return values;
}

}  // namespace halfdisk
