#include "exact_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "arc_measure.h"
#include "quadrature.h"

namespace halfdisk {
namespace {

constexpr double kRelative = 1e-4;
constexpr int kHalvings = 8;

struct Piece {
    double from, to;
};

Integrals<3> integralsOf(const Rgb& c) {
    return {c.x, c.y, c.z};
}

/// [from, to], cut at those of `cuts` (ascending) that lie within.
std::vector<Piece> piecesOf(double from, double to, const std::vector<double>& cuts) {
    std::vector<Piece> pieces;
    double start = from;
    for (auto cut = std::upper_bound(cuts.begin(), cuts.end(), from); cut != cuts.end() && *cut < to; ++cut) {
        pieces.push_back({start, *cut});
        start = *cut;
    }
    pieces.push_back({start, to});
    return pieces;
}

/// Of every pixel the integral of radiance times what responseTo weighs it with.
std::vector<Rgb> exactStrip(const Reference& reference, const Sensor& sensor, unsigned maxDepth,
                            const StopQuestion& stop) {
    const SegmentIndex& index = reference.visibility().index();
    const EyeStrip& strip = std::get<EyeStrip>(sensor);
    const Receiver receiver = Receivers(sensor, index).draw(0, 0.5, 0.5);  // refers to the strip
    std::vector<double> cuts;
    for (const VisibleArc& arc : reference.visibility().arcs(receiver.at)) cuts.push_back(arc.from);
    const auto weighted = [&](double theta) {
        const double weight = responseTo(receiver, directionAt(receiver.at, theta)).weight;
        return integralsOf(weight * reference.radiance(receiver.at, theta, maxDepth + 1));
    };
    // Pixels are counted from the left, theta from the right.
    const auto thetaAt = [&](double pixel) {
        const double place = 2.0 * pixel / strip.width - 1.0;
        return kPi / 2.0 - std::atan(place * std::tan(strip.eye.fov / 2.0));
    };
    std::vector<Rgb> pixels;
    for (std::uint32_t i = 0; i < strip.width; ++i) {
        throwIfStopped(stop);
        const auto pieces = piecesOf(thetaAt(i + 1.0), thetaAt(i), cuts);
        const Integrals<3> sum = integrateOver<3>(pieces, weighted, kRelative, kHalvings);
        pixels.emplace_back(sum[0], sum[1], sum[2]);
    }
    return pixels;
}

std::vector<Rgb> exactProfile(const Reference& reference, const Profile& profile, unsigned maxDepth,
                              const StopQuestion& stop) {
    const SegmentIndex& index = reference.visibility().index();
    double total = 0.0;
    for (const std::uint32_t segment : profile.segments) total += index.length(segment);
    const double bin = total / profile.bins;
    std::vector<Rgb> pixels(profile.bins, Rgb(0.0));
    double before = 0.0;
    for (const std::uint32_t segment : profile.segments) {
        const double length = index.length(segment);
        const auto irradiance = [&](double along) {
            const Hit hit{segment, 0.0, std::clamp(along / length, 0.0, 1.0), true};
            return integralsOf(reference.interpolatedIrradiance(hit, maxDepth) / bin);
        };
        for (std::uint32_t i = 0; i < profile.bins; ++i) {
            throwIfStopped(stop);
            const Piece part{std::max(0.0, i * bin - before), std::min(length, (i + 1.0) * bin - before)};
            if (!(part.from < part.to)) continue;
            const Integrals<3> sum = integrateOver<3>(std::array{part}, irradiance, kRelative, kHalvings);
            pixels[i] += Rgb(sum[0], sum[1], sum[2]);
        }
        before += length;
    }
    return pixels;
}

}  // namespace

bool hasExactPicture(const Sensor& sensor) {
    return std::holds_alternative<EyeStrip>(sensor) || std::holds_alternative<Profile>(sensor);
}

std::vector<Rgb> exactPicture(const Reference& reference, const Sensor& sensor, unsigned maxDepth,
                              const StopQuestion& stop) {
    assert(hasExactPicture(sensor));
    if (std::holds_alternative<EyeStrip>(sensor)) return exactStrip(reference, sensor, maxDepth, stop);
    return exactProfile(reference, std::get<Profile>(sensor), maxDepth, stop);
}

std::optional<double> relativeError(const std::vector<Rgb>& pixels, const std::vector<Rgb>& exact) {
    if (pixels.size() != exact.size() || exact.empty()) return std::nullopt;
    const auto mean = [](const Rgb& c) { return (c.x + c.y + c.z) / 3.0; };
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        sum += mean(exact[i]);
        squares += mean(pixels[i] - exact[i]) * mean(pixels[i] - exact[i]);
    }
    if (!(sum > 0.0)) return std::nullopt;
    const auto count = static_cast<double>(exact.size());
    return std::sqrt(squares / count) / (sum / count);
}

}  // namespace halfdisk
