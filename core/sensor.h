// Where is light measured, and what counts as one pixel of the answer?
//
// A sensor is a row (or grid) of pixels. Each pixel is an integral of radiance over directions, and over the
// places that it covers; Receivers draw one place. From there an estimator looks back along rays, or connects
// to light that was sent out.
#pragma once

#include "cover.h"

namespace halfdisk {

/// One number: irradiance (W/m) at a point with a normal.
struct Probe {
    ShadedPoint at;
};

/// One number: radiance (W/(m rad)) that arrives along one ray. `direction` (unit) is that of looking.
struct Look {
    Vec2 position;   ///< m
    Vec2 direction;  ///< unit
};

/// A strip of `width` pixels: mean radiance (W/(m rad)) over each, equally wide on a straight film across the
/// direction of view. Pixel 0 is the leftmost as seen by the eye.
struct EyeStrip {
    Eye eye;
    std::uint32_t width = 256;
};

/// Mean irradiance (W/m) on the fronts of walls, in `bins` bins of equal length along all of them, joined in
/// their order.
struct Profile {
    std::vector<std::uint32_t> segments;
    std::uint32_t bins = 64;
};

/// Mean fluence (W/m) over each cell of a grid; row 0 is the top one.
struct Field {
    Vec2 min{0.0}, max{1.0};  ///< m
    std::uint32_t width = 256, height = 256;
};

using Sensor = std::variant<Probe, Look, EyeStrip, Profile, Field>;

/// Bit k: alternative k of Sensor.
enum SensorBits : unsigned { kProbeBit = 1, kLookBit = 2, kEyeBit = 4, kProfileBit = 8, kFieldBit = 16 };
inline constexpr std::array<std::string_view, std::variant_size_v<Sensor>> kSensorNames{
    "probe", "look", "eye", "profile", "field"};

std::uint32_t pixelCount(const Sensor& sensor);

/// How a point weighs radiance by its direction.
enum class Weighing : std::uint8_t { cosine, even, film, one };

/// A place at which light is received.
struct Receiver {
    Weighing weighing = Weighing::cosine;
    ShadedPoint at;  ///< N is used by Weighing::cosine only
    std::uint32_t pixel = 0;
    const EyeStrip* strip = nullptr;  ///< of Weighing::film
    Vec2 direction{0.0};              ///< of Weighing::one
    bool covered = false;             ///< behind another wall (cover.h): nothing arrives
};

/// Where a sensor receives light. Keeps pointers to both.
class Receivers {
 public:
    Receivers(const Sensor& sensor, const SegmentIndex& index);
    Receivers(Sensor&&, const SegmentIndex&) = delete;

    /// A place of a pixel: u and v in (0, 1) draw it where it covers several.
    Receiver draw(std::uint32_t pixel, double u, double v) const;

 private:
    Receiver onProfile(const Profile& profile, std::uint32_t bin, double u) const;

    const Sensor* sensor_;
    const SegmentIndex* index_;
    std::vector<double> upTo_;  // running sums of the lengths of a profile's walls
    CoveredWalls covers_;
};

/// The same place for all pixels, if the sensor has only one: what light paths can be connected to. Not for
/// Look.
std::optional<Receiver> fixedReceiver(const Sensor& sensor, const SegmentIndex& index);

/// What radiance from a direction (unit, away from the receiver) adds, per radian, and to which pixel.
struct Response {
    std::uint32_t pixel = 0;
    double weight =
        0.0;  ///< 1/rad for an eye (a share of the pixel's mean); the cosine for irradiance; 1 for fluence
};
Response responseTo(const Receiver& receiver, Vec2 direction);

/// A ray that looks from the receiver: its radiance times `weight` is an estimate of the pixel.
/// `ray.pdfAngle` is 0 where light is not asked for at the receiver itself (an eye, a look).
struct Sight {
    Ray ray;
    double weight = 1.0;
};
Sight sightFrom(const Receiver& receiver, const SegmentIndex& index, double u);

/// Density (1/rad) of sightFrom where it looks by chance: cosine / 2 or 1 / 2 pi.
double pdfSight(const Receiver& receiver, Vec2 direction);

/// Whether lights are asked at the receiver itself (it gathers from all directions), not only met by what is
/// seen.
inline bool gathers(const Receiver& receiver) {
    return receiver.weighing == Weighing::cosine || receiver.weighing == Weighing::even;
}

/// Where a wall's point lies in a profile.
struct BinPlace {
    std::uint32_t bin;
    double length;  ///< m, of one bin
};
/// Prepared for many lookups by light that arrives somewhere.
class ProfileBins {
 public:
    ProfileBins(const Profile& profile, const SegmentIndex& index);
    std::optional<BinPlace> at(std::uint32_t segment, double u) const;
    double binLength() const { return binLength_; }  ///< m

 private:
    std::vector<double> startOfSegment_;  // arc length at u = 0, by segment; negative: not in the profile
    std::vector<double> length_;          // by segment
    double binLength_;
    std::uint32_t bins_;
};

/// Points that light must reach besides the walls.
std::vector<Vec2> placesOf(const Sensor& sensor);

/// Empty, or why the sensor can't be used in this scene.
std::string faultOf(const Sensor& sensor, const SegmentIndex& index);

}  // namespace halfdisk
