// What can be set for castRay? One struct, and one table per closed set: names, help, UI and file keys derive
// from them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace halfdisk {

/// How directions are drawn over the half-disk.
enum class Sampler : std::uint8_t { uniform, cosine, stratified, lobe };

/// How light that leaves an emitting segment is counted, once in any case.
enum class Emitters : std::uint8_t { sample, hit, both };

/// The switchable defects of the published listing, bit k = entry k of kDefects.
enum class Defect : std::uint8_t { frame, cosine, pdf, albedo, lightsign, falloff, offset };

template <class Enum>
struct Named {
    Enum value;
    std::string_view name;     ///< in files and on the command line
    std::string_view meaning;  ///< one line, for help and hover
};

inline constexpr std::array<Named<Sampler>, 4> kSamplers{{
    {Sampler::uniform, "uniform", "every angle of the half-disk is equally likely: pdf 1/\u03c0 per radian"},
    {Sampler::cosine, "cosine", "angles near the normal are likelier: pdf cos\u03b8/2 per radian"},
    {Sampler::stratified, "stratified", "one random angle in each of N equal slices of the half-disk"},
    {Sampler::lobe, "lobe",
     "as the surface scatters: cosine on a diffuse wall, about the mirror direction on a glossy one"},
}};

inline constexpr std::array<Named<Emitters>, 3> kEmitters{{
    {Emitters::sample, "sample", "draw points on emitting segments and send shadow rays to them"},
    {Emitters::hit, "hit", "wait until half-disk samples meet emitting segments by chance"},
    {Emitters::both, "both", "do both and weigh them by the balance heuristic"},
}};

inline constexpr std::array<Named<Defect>, 7> kDefects{{
    {Defect::frame, "frame", "the matrix is applied by rows: up lands on (-N.x, N.y), the mirrored normal"},
    {Defect::cosine, "cosine", "theta is measured from the tangent, yet the weight is cos(theta)"},
    {Defect::pdf, "pdf", "samples are averaged without dividing by their pdf"},
    {Defect::albedo, "albedo", "albedo / pi, the 3D normalisation, instead of albedo / 2"},
    {Defect::lightsign, "lightsign", "N.L is taken with L along the light's travel, so lit walls turn black"},
    {Defect::falloff, "falloff", "a point light is not divided by its distance"},
    {Defect::offset, "offset", "rays start exactly on the wall and may hit it again"},
}};

template <class Enum, std::size_t Count>
constexpr std::optional<Enum> valueOf(const std::array<Named<Enum>, Count>& table, std::string_view name) {
    for (const Named<Enum>& entry : table)
        if (entry.name == name) return entry.value;
    return std::nullopt;
}

template <class Enum, std::size_t Count>
constexpr std::string_view nameOf(const std::array<Named<Enum>, Count>& table, Enum value) {
    for (const Named<Enum>& entry : table)
        if (entry.value == value) return entry.name;
    return {};
}

/// A set of defects. Empty: the corrected castRay.
struct DefectSet {
    std::uint8_t bits = 0;

    static constexpr DefectSet all() { return {(1u << kDefects.size()) - 1u}; }
    constexpr bool has(Defect d) const { return (bits >> static_cast<unsigned>(d)) & 1u; }
    constexpr void set(Defect d, bool on) {
        const auto bit = static_cast<std::uint8_t>(1u << static_cast<unsigned>(d));
        bits = static_cast<std::uint8_t>(on ? bits | bit : bits & ~bit);
    }
    constexpr bool operator==(const DefectSet&) const = default;
};

/// Range, default and meaning of a whole-number setting.
struct NumberInfo {
    std::string_view name;
    std::string_view symbol;  ///< on screen
    std::string_view meaning;
    std::uint64_t least, most, initial;
};

inline constexpr NumberInfo kSamplesInfo{"samples", "N",           "half-disk samples per bounce",
                                         1,         1'000'000'000, 16};
inline constexpr NumberInfo kMaxDepthInfo{
    "depth", "maxDepth", "scatterings between the light and the half-disk", 0, 1000, 1};
inline constexpr NumberInfo kMaxSpecularInfo{
    "specular", "maxSpecular", "mirror and glass events in a row; they never count as depth", 0, 1000, 32};
inline constexpr NumberInfo kSeedInfo{
    "seed", "seed", "picks the random numbers; the same seed gives the same picture", 0, UINT64_MAX, 1};

/// All that castRay needs beside the scene.
struct Settings {
    std::uint32_t samples = kSamplesInfo.initial;    ///< N, per bounce
    std::uint32_t maxDepth = kMaxDepthInfo.initial;  ///< E at this depth, L at one more
    std::uint64_t seed = kSeedInfo.initial;
    Sampler sampler = Sampler::uniform;
    Emitters emitters = Emitters::sample;
    DefectSet defects;                                     ///< any: run the as-printed variant
    std::uint32_t maxSpecular = kMaxSpecularInfo.initial;  ///< mirror and glass events in a row
    bool operator==(const Settings&) const = default;
};

}  // namespace halfdisk
