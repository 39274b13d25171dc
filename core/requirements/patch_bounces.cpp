#include "core/requirements/patch_bounces.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "core/form_factors.h"
#include "core/radiosity_system.h"
#include "core/rng.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostWalls = 100;  // the form factors take n^3
constexpr std::uint32_t kPatches = 120;
constexpr std::uint32_t kMostBounces = 1000;
constexpr std::uint32_t kPlaces = 512;  // of the sensor that are asked what they see

/// One number for each patch.
using Row = std::vector<double>;

class Exchange {
 public:
    Exchange(const Visibility& visibility, const Patches& patches, const StopQuestion& stop)
        : patches_(patches), lengths_(exchangeLengths(visibility.index(), patches, stop)) {}

    /// Irradiance of each patch from radiosities 1 W/m (B = 2 L): sum over j of F_ij B_j.
    Row arriving(const Row& radiosity) const {
        const std::size_t size = patches_.size();
        Row sum(size);
        for (std::size_t i = 0; i < size; ++i) {
            double total = 0.0;
            for (std::size_t j = 0; j < size; ++j) total += lengths_[i * size + j] * radiosity[j];
            sum[i] = total / patches_.all()[i].length;
        }
        return sum;
    }

 private:
    const Patches& patches_;
    ExchangeLengths lengths_;
};

/// How often each patch is what the sensor measures: the patch that a place lies on, or the one that it sees.
Row weightsOf(const Sensor& sensor, const SegmentIndex& index, const Patches& patches) {
    Row weights(patches.size());
    const Rng rng = Rng(1, 0);
    const std::uint32_t pixels = pixelCount(sensor);
    const Receivers receivers(sensor, index);
    const auto isLit = [&](std::uint32_t segment, bool front) {
        const Patches::Range range = patches.of(segment, front);
        return range.first < range.end;
    };
    for (std::uint32_t k = 0; k < kPlaces; ++k) {
        const std::uint32_t pixel = static_cast<std::uint32_t>(std::uint64_t{k} * pixels / kPlaces);
        const Receiver receiver = receivers.draw(pixel, rng.uniform(k, 0), rng.uniform(k, 1));
        if (receiver.covered) continue;
        if (receiver.weighing == Weighing::cosine && receiver.at.segment != kNoSegment) {
            const Segment& wall = index.scene().segments[receiver.at.segment];
            const double u = glm::dot(receiver.at.P - wall.a, wall.b - wall.a) /
                             glm::dot(wall.b - wall.a, wall.b - wall.a);
            const bool front = glm::dot(receiver.at.N, index.normal(receiver.at.segment)) > 0.0;
            if (isLit(receiver.at.segment, front))
                ++weights[patches.at(receiver.at.segment, front, std::clamp(u, 0.0, 1.0))];
            continue;
        }
        const Hit hit = index.closestHit(sightFrom(receiver, index, rng.uniform(k, 2)).ray);
        if (hit && isLit(hit.segment, hit.front)) ++weights[patches.at(hit.segment, hit.front, hit.u)];
    }
    return weights;
}

/// Largest factor by which A = rho F makes a positive row grow, in the end.
double spectralRadiusOf(const Exchange& exchange, const Patches& patches, const Row& albedo,
                        const StopQuestion& stop) {
    constexpr int kMostSteps = 300;
    Row light(albedo.size(), 1.0);
    for (int step = 0; step < kMostSteps; ++step) {
        throwIfStopped(stop);
        Row next = exchange.arriving(light);
        double most = 0.0;
        for (std::size_t i = 0; i < next.size(); ++i) most = std::max(most, next[i] *= albedo[i]);
        if (!(most > 0.0)) return 0.0;
        for (double& value : next) value /= most;
        // The other half of an exchange between two walls alternates: the mean of two steps does not.
        double change = 0.0;
        for (std::size_t i = 0; i < next.size(); ++i) {
            next[i] = (next[i] + light[i]) / 2.0;
            change = std::max(change, std::abs(next[i] - light[i]));
        }
        light = std::move(next);
        constexpr double kSettled = 1e-6;  // everywhere: covered patches go dark while the rest stays
        if (change < kSettled) break;
    }
    // Rayleigh's quotient, with the weights l / rho for which rho F is symmetric: exact to second order.
    const Row image = exchange.arriving(light);
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (albedo[i] <= 0.0) continue;
        above += patches.all()[i].length * image[i] * light[i];
        below += patches.all()[i].length * light[i] * light[i] / albedo[i];
    }
    return below > 0.0 ? above / below : 0.0;
}

struct Sums {
    double mean = 0.0, square = 0.0;
};

Sums sumsOf(const Row& light, const Row& weights) {
    Sums sums;
    for (std::size_t i = 0; i < light.size(); ++i) {
        sums.mean += weights[i] * light[i];
        sums.square += weights[i] * light[i] * light[i];
    }
    return sums;
}

/// Adds to `sum`, the light of all scatterings up to the last two, what all others would bring: the light
/// falls by a fixed share every two of them, for the other half of an exchange between two walls alternates.
/// Nearly all of it if it never falls.
void addEndless(Row& sum, const Row& last, const Row& before, double share) {
    constexpr double kNever = 1.0 - 1e-12;
    const double further = std::min(share, kNever) / (1.0 - std::min(share, kNever));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += further * (last[i] + before[i]);
}

/// beyond[D] of one channel.
Row beyondOf(const Exchange& exchange, const Row& albedo, const Row& direct, const Row& weights,
             double tolerance, const StopQuestion& stop) {
    const double places = std::accumulate(weights.begin(), weights.end(), 0.0);
    // Light that arrives after exactly k scatterings, and the sums of all up to there.
    std::vector<Row> upTo{direct};
    Row light = direct, before, beforeThat;
    bool settled = false;
    for (std::uint32_t k = 1; k <= kMostBounces && !settled; ++k) {
        throwIfStopped(stop);
        beforeThat = std::exchange(before, light);
        for (std::size_t i = 0; i < light.size(); ++i) light[i] *= albedo[i];
        light = exchange.arriving(light);
        Row sum = upTo.back();
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += light[i];
        upTo.push_back(std::move(sum));
        // Nowhere in the room, not only at the sensor: a bounce may bring it nothing, and the next one a lot.
        const double most = *std::max_element(light.begin(), light.end());
        settled = most <= 1e-3 * tolerance * sumsOf(upTo.back(), weights).mean / places;
    }
    Row endless = upTo.back();
    if (!settled) {
        const double now = std::accumulate(light.begin(), light.end(), 0.0),
                     then = std::accumulate(beforeThat.begin(), beforeThat.end(), 0.0);
        addEndless(endless, light, before, now / then);
    }
    const Sums all = sumsOf(endless, weights);
    Row beyond;
    for (const Row& sum : upTo) {
        Row rest = endless;
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= sum[i];
        const Sums left = sumsOf(rest, weights);
        beyond.push_back(all.mean > 0.0 ? std::max(left.mean / all.mean, std::sqrt(left.square / all.square))
                                        : 0.0);
        if (beyond.back() <= tolerance) break;
    }
    return beyond;
}

}  // namespace

std::optional<PatchBounces> patchBounces(const SegmentIndex& index, const Sensor& sensor, double tolerance,
                                         const StopQuestion& stop) {
    if (index.scene().segments.size() > kMostWalls) return std::nullopt;
    const Visibility visibility(index, stop);
    std::optional<Patches> patches;
    try {
        patches.emplace(visibility, kPatches, stop);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
    const Row weights = weightsOf(sensor, index, *patches);
    if (std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0.0; }))
        return std::nullopt;
    const Exchange exchange(visibility, *patches, stop);
    PatchBounces bounces;
    bounces.patches = patches->size();
    std::vector<Rgb> straight;
    for (const Patch& patch : patches->all()) straight.push_back(meanDirect(visibility, patch));
    for (int channel = 0; channel < 3; ++channel) {
        Row albedo, emitted;
        for (const Patch& patch : patches->all()) {
            albedo.push_back(std::get<Diffuse>(index.material(patch.segment)).albedo[channel]);
            emitted.push_back(2.0 * index.scene().segments[patch.segment].emission[channel]);
        }
        bounces.spectralRadius =
            std::max(bounces.spectralRadius, spectralRadiusOf(exchange, *patches, albedo, stop));
        Row direct = exchange.arriving(emitted);
        for (std::size_t i = 0; i < direct.size(); ++i) direct[i] += straight[i][channel];
        const Row beyond = beyondOf(exchange, albedo, direct, weights, tolerance, stop);
        if (bounces.beyond.size() < beyond.size()) bounces.beyond.resize(beyond.size());
        for (std::size_t i = 0; i < beyond.size(); ++i)
            bounces.beyond[i] = std::max(bounces.beyond[i], beyond[i]);
    }
    return bounces;
}

}  // namespace halfdisk
