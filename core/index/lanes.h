// How do several floats go through one instruction? A thin wrapper over the compiler's vector types, as wide
// as the instruction set that this file is compiled for.
//
// Included only by the kernels; the unnamed namespace gives each instruction set its own copy, so that the
// linker never hands an old processor a new one's code.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace halfdisk {
namespace {

#if defined(__AVX512F__) && defined(__AVX512DQ__)
constexpr int kLanes = 16;
#elif defined(__AVX2__) && defined(__FMA__)
constexpr int kLanes = 8;
#else
constexpr int kLanes = 4;
#endif

using Floats [[gnu::vector_size(kLanes * 4)]] = float;
using Ints [[gnu::vector_size(kLanes * 4)]] = std::int32_t;

inline Floats load(const float* from) {
    return *reinterpret_cast<const Floats*>(from);
}
inline Ints load(const std::int32_t* from) {
    return *reinterpret_cast<const Ints*>(from);
}
inline void store(float* to, Floats values) {
    *reinterpret_cast<Floats*>(to) = values;
}
inline void store(std::int32_t* to, Ints values) {
    *reinterpret_cast<Ints*>(to) = values;
}
inline Floats all(float value) {
    return value - Floats{};  // + would turn -0 into 0, and takes an instruction
}
inline Ints all(std::int32_t value) {
    return Ints{} + value;
}
inline Ints bitsOf(Floats values) {
    return reinterpret_cast<Ints>(values);
}
inline Floats asFloats(Ints bits) {
    return reinterpret_cast<Floats>(bits);
}

inline Floats abs(Floats values) {
    return asFloats(bitsOf(values) & 0x7FFFFFFF);
}
/// `value` with its sign turned where `sign` is negative.
inline Floats turned(Floats value, Floats sign) {
    return asFloats(bitsOf(value) ^ (bitsOf(sign) & INT32_MIN));
}

// Comparisons give one bit a lane.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
using Mask = __mmask16;
inline Floats chosen(Mask mask, Floats yes, Floats no) {
    return _mm512_mask_mov_ps(no, mask, yes);
}
inline Mask lessEqual(Floats a, Floats b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
}
/// True for NaN.
inline Mask notGreater(Floats a, Floats b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_NGT_UQ);
}
inline Mask notEqual(Ints a, Ints b) {
    return _mm512_cmpneq_epi32_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b));
}
inline Mask less(Floats a, Floats b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ);
}
inline Ints chosen(Mask mask, Ints yes, Ints no) {
    return reinterpret_cast<Ints>(
        _mm512_mask_mov_epi32(reinterpret_cast<__m512i>(no), mask, reinterpret_cast<__m512i>(yes)));
}
inline Mask less(Ints a, Ints b) {
    return _mm512_cmplt_epi32_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b));
}
inline unsigned bits(Mask mask) {
    return mask;
}
// The plain forms warn of an uninitialised register in GCC 12.
inline Floats min(Floats a, Floats b) {
    return _mm512_maskz_min_ps(0xFFFF, a, b);
}
inline Floats max(Floats a, Floats b) {
    return _mm512_maskz_max_ps(0xFFFF, a, b);
}
inline Floats roughInverse(Floats values) {
    return _mm512_maskz_rcp14_ps(0xFFFF, values);
}
/// a b + c and a b - c, rounded once.
inline Floats mulAdd(Floats a, Floats b, Floats c) {
    return _mm512_fmadd_ps(a, b, c);
}
inline Floats mulSub(Floats a, Floats b, Floats c) {
    return _mm512_fmsub_ps(a, b, c);
}
#else
using Mask = Ints;
inline Floats chosen(Mask mask, Floats yes, Floats no) {
    return mask ? yes : no;
}
inline Mask lessEqual(Floats a, Floats b) {
    return a <= b;
}
/// True for NaN.
inline Mask notGreater(Floats a, Floats b) {
    return ~(a > b);
}
inline Mask notEqual(Ints a, Ints b) {
    return a != b;
}
inline Mask less(Floats a, Floats b) {
    return a < b;
}
inline Ints chosen(Mask mask, Ints yes, Ints no) {
    return mask ? yes : no;
}
inline Mask less(Ints a, Ints b) {
    return a < b;
}
#if defined(__AVX2__) && defined(__FMA__)
inline unsigned bits(Mask mask) {
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
}
inline Floats min(Floats a, Floats b) {
    return _mm256_min_ps(a, b);
}
inline Floats max(Floats a, Floats b) {
    return _mm256_max_ps(a, b);
}
inline Floats roughInverse(Floats values) {
    return _mm256_rcp_ps(values);
}
inline Floats mulAdd(Floats a, Floats b, Floats c) {
    return _mm256_fmadd_ps(a, b, c);
}
inline Floats mulSub(Floats a, Floats b, Floats c) {
    return _mm256_fmsub_ps(a, b, c);
}
#else
inline unsigned bits(Mask mask) {
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    unsigned all = 0;
    for (int i = 0; i < kLanes; ++i) all |= (mask[i] != 0 ? 1u : 0u) << i;
    return all;
#endif
}
inline Floats min(Floats a, Floats b) {
    return a < b ? a : b;
}
inline Floats max(Floats a, Floats b) {
    return a > b ? a : b;
}
inline Floats roughInverse(Floats values) {
    return 1.0f / values;
}
inline Floats mulAdd(Floats a, Floats b, Floats c) {
    return a * b + c;
}
inline Floats mulSub(Floats a, Floats b, Floats c) {
    return a * b - c;
}
#endif
#endif

/// Right to a few roundings; NaN for 0.
inline Floats inverse(Floats values) {
    const Floats rough = roughInverse(values);
    return rough * (2.0f - values * rough);
}

/// What `join` makes of all lanes.
template <class Join>
[[gnu::always_inline]] inline float joined(Floats values, const Join& join) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    values = join(values, __builtin_shufflevector(values, values, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4,
                                                  5, 6, 7));
    values = join(values, __builtin_shufflevector(values, values, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8,
                                                  9, 10, 11));
    values = join(values, __builtin_shufflevector(values, values, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14,
                                                  15, 12, 13));
    values = join(values, __builtin_shufflevector(values, values, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13,
                                                  12, 15, 14));
#else
    for (int i = 1; i < kLanes; ++i) values = join(values, all(values[i]));
#endif
    return values[0];
}

/// The least of all lanes.
inline float least(Floats values) {
    return joined(values, [](Floats a, Floats b) { return min(a, b); });
}

/// The largest of all lanes.
inline float most(Floats values) {
    return joined(values, [](Floats a, Floats b) { return max(a, b); });
}

}  // namespace
}  // namespace halfdisk
