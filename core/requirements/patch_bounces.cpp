#include "core/requirements/patch_bounces.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/radiosity_system.h"
#include "core/requirements/patch_exchange.h"
#include "core/requirements/sensor_view.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostWalls = 100;                     // the form factors take n^3
constexpr std::uint32_t kPatches = 40, kMostPatches = 600;  // about, at first; at most
constexpr std::uint32_t kLeast = 4;                         // times as many as at first
constexpr std::uint32_t kPlaces = 16;                       // of the sensor, for each patch
constexpr std::uint32_t kMostBounces = 1000;
constexpr double kDust = 1e-12;  // of the brightest: rounding

/// Light at the sensor, of one channel.
struct ByScatterings {
    Row after;               ///< [k]: of light that was scattered exactly k times
    double endless = 0.0;    ///< of all that was scattered more often
    double brightest = 0.0;  ///< if as much arrived everywhere as where most does, unscattered
};

/// `now` and `later` as in SensorView.
double sensed(const SensorView& view, int channel, const Row& now, const Row& later) {
    double sum = 0.0;
    for (std::size_t i = 0; i < now.size(); ++i)
        sum += view.now[i][channel] * now[i] + view.later[i][channel] * later[i];
    return sum;
}

double sumOf(const Row& light) {
    return std::accumulate(light.begin(), light.end(), 0.0);
}

ByScatterings follow(const Exchange& exchange, const SensorView& view, int channel, const Row& albedo,
                     Row light, double tolerance, const StopQuestion& stop) {
    ByScatterings found{{view.straight[channel]}, 0.0, 0.0};
    double all = found.after.front();
    const Row ones(light.size(), 1.0);
    const double mostSensed = sensed(view, channel, ones, ones);
    found.brightest = mostSensed * *std::max_element(light.begin(), light.end());
    Row before = light, beforeThat;
    for (std::uint32_t k = 1; k <= kMostBounces; ++k) {
        throwIfStopped(stop);
        beforeThat = std::exchange(before, light);
        for (std::size_t i = 0; i < light.size(); ++i) light[i] *= albedo[i];
        light = exchange.arriving(light);
        found.after.push_back(sensed(view, channel, light, before));
        all += found.after.back();
        // Nowhere in the room, not only at the sensor: a bounce may bring it nothing, and the next one a lot.
        const double most = *std::max_element(light.begin(), light.end());
        if (k > 2 && most * mostSensed <= 1e-3 * tolerance * all) break;
    }
    // It falls by a fixed share every two scatterings, for the other half of an exchange between two walls
    // alternates. Nearly all of it is left if it never falls.
    constexpr double kNever = 1.0 - 1e-12;
    const double then = sumOf(beforeThat), share = then > 0.0 ? std::min(sumOf(light) / then, kNever) : 0.0;
    found.endless = share / (1.0 - share) * (*(found.after.end() - 1) + *(found.after.end() - 2));
    return found;
}

/// By one division into patches.
struct Division {
    std::size_t patches = 0;
    double spectralRadius = 0.0;
    double light = 0.0;
    Row beyond;  ///< [D]: share of the light, of all channels, that is scattered more often
};

Division divisionOf(const Visibility& visibility, const Patches& patches, const Sensor& sensor,
                    double tolerance, const StopQuestion& stop) {
    const SegmentIndex& index = visibility.index();
    const Exchange exchange(visibility, patches, stop);
    std::vector<Rgb> direct;
    for (const Patch& patch : patches.all()) direct.push_back(meanDirect(visibility, patch));
    for (int channel = 0; channel < 3; ++channel) {
        Row emitted;
        for (const Patch& patch : patches.all())
            emitted.push_back(2.0 * index.scene().segments[patch.segment].emission[channel]);
        const Row byLamps = exchange.arriving(emitted);
        for (std::size_t i = 0; i < byLamps.size(); ++i) direct[i][channel] += byLamps[i];
    }
    const SensorView view = viewOf(sensor, visibility, patches, direct,
                                   kPlaces * static_cast<std::uint32_t>(patches.size()), stop);
    Division division{patches.size(), 0.0, 0.0, {}};
    Row after;
    double endless = 0.0, brightest = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        Row albedo;
        for (const Patch& patch : patches.all())
            albedo.push_back(std::get<Diffuse>(index.material(patch.segment)).albedo[channel]);
        division.spectralRadius =
            std::max(division.spectralRadius, spectralRadiusOf(exchange, patches, albedo, stop));
        Row arriving;
        for (const Rgb& light : direct) arriving.push_back(light[channel]);
        const ByScatterings found =
            follow(exchange, view, channel, albedo, std::move(arriving), tolerance, stop);
        if (after.size() < found.after.size()) after.resize(found.after.size());
        for (std::size_t k = 0; k < found.after.size(); ++k) after[k] += found.after[k];
        endless += found.endless;
        brightest += found.brightest;
    }
    const double all = sumOf(after) + endless;
    if (!(all > kDust * brightest)) return division;
    division.light = all / 3.0;
    double rest = endless;
    division.beyond.resize(after.size());
    for (std::size_t k = after.size(); k-- > 0; rest += after[k]) division.beyond[k] = rest / all;
    return division;
}

/// What both tell, the finer one with the difference as its error. Two divisions may agree by chance, as
/// where a wall is lit evenly about its middle: no less than half of what coarser ones told, `before`, and of
/// what one scattering less does.
PatchBounces compared(const Division& half, const Division& whole, const std::optional<PatchBounces>& before,
                      double tolerance) {
    PatchBounces bounces{
        whole.spectralRadius, whole.patches, whole.light, std::abs(whole.light - half.light), {}};
    if (before) bounces.lightError = std::max(bounces.lightError, before->lightError / 2.0);
    for (std::uint32_t depth = 0; depth < whole.beyond.size(); ++depth) {
        const double share = whole.beyond[depth],
                     byHalf = half.beyond[std::min<std::size_t>(depth, half.beyond.size() - 1)];
        double error = std::abs(share - byHalf);
        if (depth > 0) error = std::max(error, bounces.beyond.back().standardError / 2.0);
        if (before && depth < before->beyond.size())
            error = std::max(error, before->beyond[depth].standardError / 2.0);
        bounces.beyond.push_back({depth, share, error});
        if (isEnough(bounces.beyond.back(), tolerance)) break;
    }
    return bounces;
}

/// Whether more patches need not mend it.
bool isFine(const PatchBounces& bounces, double tolerance) {
    constexpr double kSmall = 0.1;     // of the tolerance
    constexpr double kOfLight = 0.02;  // ways are held against it
    return bounces.beyond.back().standardError <= kSmall * tolerance &&
           bounces.lightError <= kOfLight * bounces.light;
}

/// Whether three divisions with these cuts are possible.
bool leaveRoom(const Visibility& visibility, std::span<const WallPlace> cuts, const StopQuestion& stop) {
    try {
        return kLeast * Patches(visibility, {1, cuts}, stop).size() <= kMostPatches;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

}  // namespace

std::optional<PatchBounces> patchBounces(const SegmentIndex& index, const Sensor& sensor, double tolerance,
                                         const StopQuestion& stop) {
    if (index.scene().segments.size() > kMostWalls) return std::nullopt;
    const Visibility visibility(index, stop);
    std::vector<WallPlace> cuts = shadowEdges(visibility, stop);
    if (!leaveRoom(visibility, cuts, stop)) cuts.clear();
    // Every stretch in so many times as many: a short wall's error shows as well.
    const auto divided = [&](std::uint32_t times) -> std::optional<Division> {
        try {
            const Patches patches(visibility, {kPatches, cuts, times}, stop);
            if (patches.size() > kMostPatches) return std::nullopt;
            Division division = divisionOf(visibility, patches, sensor, tolerance, stop);
            if (division.beyond.empty()) return std::nullopt;
            return division;
        } catch (const std::invalid_argument&) {
            return std::nullopt;
        }
    };
    std::optional<Division> half = divided(1);
    if (!half) return std::nullopt;
    std::optional<PatchBounces> bounces;
    for (std::uint32_t times = 2;; times *= 2) {
        std::optional<Division> whole = divided(times);
        if (!whole) return bounces;
        bounces = compared(*half, *whole, bounces, tolerance);
        if (times >= kLeast && isFine(*bounces, tolerance)) return bounces;
        half = std::move(whole);
    }
}

}  // namespace halfdisk
