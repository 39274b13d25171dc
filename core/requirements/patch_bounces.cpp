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

constexpr std::size_t kMostWalls = 100;                    // the form factors take n^3
constexpr std::size_t kPatches = 120, kMostPatches = 500;  // at first; at most
constexpr std::uint32_t kPlaces = 16;                      // of the sensor, for each patch
constexpr double kSmall = 0.1;  // of the tolerance: an error that more patches need not mend
constexpr std::uint32_t kMostBounces = 1000;

/// Light at the sensor, of one channel.
struct ByScatterings {
    Row after;             ///< [k]: of light that was scattered exactly k times
    double endless = 0.0;  ///< of all that was scattered more often
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
    ByScatterings found{{view.straight[channel]}};
    double all = found.after.front();
    const Row ones(light.size(), 1.0);
    const double mostSensed = sensed(view, channel, ones, ones);
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
    double endless = 0.0;
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
    }
    const double all = sumOf(after) + endless;
    if (!(all > 0.0)) return division;
    division.light = all / 3.0;
    double rest = endless;
    division.beyond.resize(after.size());
    for (std::size_t k = after.size(); k-- > 0; rest += after[k]) division.beyond[k] = rest / all;
    return division;
}

/// What both tell, the finer one with the difference as its error.
PatchBounces compared(const Division& half, const Division& whole, double tolerance) {
    PatchBounces bounces{
        whole.spectralRadius, whole.patches, whole.light, std::abs(whole.light - half.light), {}};
    for (std::uint32_t depth = 0; depth < whole.beyond.size(); ++depth) {
        const double share = whole.beyond[depth],
                     byHalf = half.beyond[std::min<std::size_t>(depth, half.beyond.size() - 1)];
        // Two divisions may agree by chance, where they didn't one scattering before.
        const double before = bounces.beyond.empty() ? 0.0 : bounces.beyond.back().standardError;
        bounces.beyond.push_back({depth, share, std::max(std::abs(share - byHalf), before / 2.0)});
        if (isEnough(bounces.beyond.back(), tolerance)) break;
    }
    return bounces;
}

}  // namespace

std::optional<PatchBounces> patchBounces(const SegmentIndex& index, const Sensor& sensor, double tolerance,
                                         const StopQuestion& stop) {
    if (index.scene().segments.size() > kMostWalls) return std::nullopt;
    const Visibility visibility(index, stop);
    std::vector<WallPlace> cuts = shadowEdges(visibility, stop);
    if (cuts.size() > kPatches) cuts.clear();
    const auto dividedInto = [&](std::size_t wanted) -> std::optional<Division> {
        try {
            const Patches patches(visibility, static_cast<std::uint32_t>(wanted), cuts, stop);
            if (patches.size() > kMostPatches) return std::nullopt;
            Division division = divisionOf(visibility, patches, sensor, tolerance, stop);
            if (division.beyond.empty()) return std::nullopt;
            return division;
        } catch (const std::invalid_argument&) {
            return std::nullopt;
        }
    };
    std::optional<Division> half = dividedInto(kPatches / 2);
    if (!half) return std::nullopt;
    auto wanted = std::max(kPatches, 2 * half->patches);
    std::optional<PatchBounces> bounces;
    while (std::optional<Division> whole = dividedInto(wanted)) {
        bounces = compared(*half, *whole, tolerance);
        if (bounces->beyond.back().standardError <= kSmall * tolerance) break;
        half = std::move(whole);
        wanted *= 2;
    }
    return bounces;
}

}  // namespace halfdisk
