// The same for several doubles: as lanes.h, which says why each instruction set has its own copy.
#pragma once

#include "core/index/lanes.h"

namespace halfdisk {
namespace {

constexpr int kDoubles = kLanes / 2;

using Doubles [[gnu::vector_size(kDoubles * 8)]] = double;
using Longs [[gnu::vector_size(kDoubles * 8)]] = std::int64_t;

inline Doubles load(const double* from) {
    return *reinterpret_cast<const Doubles*>(from);
}
inline void store(double* to, Doubles values) {
    *reinterpret_cast<Doubles*>(to) = values;
}
inline Doubles all(double value) {
    return value - Doubles{};
}
inline Longs bitsOf(Doubles values) {
    return reinterpret_cast<Longs>(values);
}
inline Doubles asDoubles(Longs bits) {
    return reinterpret_cast<Doubles>(bits);
}
inline Doubles abs(Doubles values) {
    return asDoubles(bitsOf(values) & INT64_MAX);
}
/// `value` with its sign turned where `sign` is negative.
inline Doubles turned(Doubles value, Doubles sign) {
    return asDoubles(bitsOf(value) ^ (bitsOf(sign) & INT64_MIN));
}

#if defined(__AVX512F__) && defined(__AVX512DQ__)
using DoubleMask = __mmask8;
inline DoubleMask less(Doubles a, Doubles b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
inline DoubleMask differ(DoubleMask a, DoubleMask b) {
    return a ^ b;
}
inline DoubleMask lessEqual(Doubles a, Doubles b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ);
}
inline DoubleMask notEqual(Doubles a, Doubles b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_NEQ_UQ);
}
inline DoubleMask inverted(DoubleMask mask) {
    return static_cast<DoubleMask>(~mask);
}
inline Doubles chosen(DoubleMask mask, Doubles yes, Doubles no) {
    return _mm512_mask_mov_pd(no, mask, yes);
}
inline unsigned laneBits(DoubleMask mask) {
    return mask;
}
inline Doubles min(Doubles a, Doubles b) {
    return _mm512_maskz_min_pd(0xFF, a, b);
}
inline Doubles max(Doubles a, Doubles b) {
    return _mm512_maskz_max_pd(0xFF, a, b);
}
#else
using DoubleMask = Longs;
inline DoubleMask less(Doubles a, Doubles b) {
    return a < b;
}
inline DoubleMask differ(DoubleMask a, DoubleMask b) {
    return a ^ b;
}
inline DoubleMask lessEqual(Doubles a, Doubles b) {
    return a <= b;
}
inline DoubleMask notEqual(Doubles a, Doubles b) {
    return a != b;
}
inline DoubleMask inverted(DoubleMask mask) {
    return ~mask;
}
inline Doubles chosen(DoubleMask mask, Doubles yes, Doubles no) {
    return mask ? yes : no;
}
inline unsigned laneBits(DoubleMask mask) {
#if defined(__AVX2__) && defined(__FMA__)
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#elif defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
#else
    unsigned all = 0;
    for (int i = 0; i < kDoubles; ++i) all |= (mask[i] != 0 ? 1u : 0u) << i;
    return all;
#endif
}
inline Doubles min(Doubles a, Doubles b) {
    return a < b ? a : b;
}
inline Doubles max(Doubles a, Doubles b) {
    return a > b ? a : b;
}
#endif

/// The least of all lanes, none of which is NaN.
inline double least(Doubles values) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    values = min(values, __builtin_shufflevector(values, values, 4, 5, 6, 7, 0, 1, 2, 3));
    values = min(values, __builtin_shufflevector(values, values, 2, 3, 0, 1, 6, 7, 4, 5));
    values = min(values, __builtin_shufflevector(values, values, 1, 0, 3, 2, 5, 4, 7, 6));
    return values[0];
#else
    double found = values[0];
    for (int i = 1; i < kDoubles; ++i) found = values[i] < found ? values[i] : found;
    return found;
#endif
}

}  // namespace
}  // namespace halfdisk
