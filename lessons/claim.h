// What does a step's text promise that can be measured? `halfdisk verify` measures it, so that text and
// program cannot part ways.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/settings.h"
#include "lessons/instruments.h"
#include "lessons/maker.h"
#include "lessons/toml_document.h"
#include "lessons/wall_point.h"

namespace halfdisk {

/// What is measured: at P, or of a whole picture. Of colours the mean of the three channels.
enum class Quantity : std::uint8_t {
    irradiance,
    direct,
    indirect,
    radiance,
    exact,
    error,
    variance,
    spread,
    standardError,
    relativeError,
    rays,
    nonFinite,
    heaviest,
    noise,
    pictureError,
    raysTo,
    planRays,
    planBounces,
    lost
};

inline constexpr std::array<Named<Quantity>, 19> kQuantities{{
    {Quantity::irradiance, "irradiance", "E at P, W/m"},
    {Quantity::direct, "direct", "the part of E that was never scattered, W/m (cast-ray)"},
    {Quantity::indirect, "indirect", "the part of E that was, W/m (cast-ray)"},
    {Quantity::radiance, "radiance", "L of the wall, W/(m rad), where it is matt"},
    {Quantity::exact, "exact", "the exact E, where it is known, W/m"},
    {Quantity::error, "error", "how far E is off the exact one, as a share of it"},
    {Quantity::variance, "variance", "of one sample's estimate of E, (W/m)^2: N times that of a mean of N"},
    {Quantity::spread, "spread", "of one sample's estimate of E, W/m: the root of the variance"},
    {Quantity::standardError, "standardError", "of E, over the repeats, W/m"},
    {Quantity::relativeError, "relativeError", "typical error of one run of N samples, as a share of E"},
    {Quantity::rays, "rays", "how many were cast, in one repeat"},
    {Quantity::nonFinite, "nonFinite", "how many values were infinite or not a number"},
    {Quantity::heaviest, "heaviest",
     "share of a pixel's light that comes by the path that brings most of it"},
    {Quantity::noise, "noise",
     "of the finished picture: what chance still does to it, as a share of its light"},
    {Quantity::pictureError, "pictureError",
     "how far the finished picture is off the exact one, as a share of its light"},
    {Quantity::raysTo, "raysTo",
     "how many it takes until a picture is off by \"wishedError\", as the trade tells"},
    {Quantity::planRays, "planRays",
     "how many the requirements' plan takes until its noise is \"tolerance\""},
    {Quantity::planBounces, "planBounces", "how many scatterings the requirements' plan follows"},
    {Quantity::lost, "lost", "share of the rays that go wrong in the tracer that \"dial\" chooses"},
}};

enum class Relation : std::uint8_t { atLeast, atMost, equals };

inline constexpr std::array<Named<Relation>, 3> kRelations{{
    {Relation::atLeast, "atLeast", "the measured value is no smaller"},
    {Relation::atMost, "atMost", "the measured value is no larger"},
    {Relation::equals, "equals", "the measured value is this one, within the tolerance"},
}};

/// Which picture is measured.
enum class ClaimPicture : std::uint8_t { seen, eye, field, profile };

inline constexpr std::array<Named<ClaimPicture>, 4> kClaimPictures{{
    {ClaimPicture::seen, "seen", "what the scene's eye sees, or else the light along P's wall"},
    {ClaimPicture::eye, "eye", "what the scene's eye sees"},
    {ClaimPicture::field, "field", "the light in the room"},
    {ClaimPicture::profile, "profile", "the light along P's wall"},
}};

/// A measurement.
struct Trial {
    Settings settings;
    WallPoint at{0, 0.5};
    Maker maker = makerOf("cast-ray");     ///< at P cast-ray goes by `settings`
    std::uint64_t repeats = 16;            ///< of cast-ray; of others, `settings.samples` are independent
    std::optional<std::uint32_t> pixel{};  ///< of Quantity::heaviest: one of the eye's strip
    ClaimPicture picture = ClaimPicture::seen;  ///< of Quantity::noise and pictureError
    InstrumentSettings instruments{};           ///< of Quantity::raysTo, planRays, planBounces and lost
    bool operator==(const Trial&) const = default;
};

struct Claim {
    std::string name{};  ///< by which the lesson's texts show the number; empty if they don't
    std::string says;    ///< the sentence that is to be true
    Quantity quantity = Quantity::irradiance;
    Trial of;
    std::optional<Trial> over;  ///< what is measured is divided by the same of this one
    Relation relation = Relation::equals;
    double number = 0.0;
    double tolerance = 0.0;  ///< of `equals`, on both sides
    TextPosition where{};    ///< of the number, in the lesson file
    bool operator==(const Claim&) const = default;
};

}  // namespace halfdisk
