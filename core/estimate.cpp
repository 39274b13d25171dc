#include "estimate.h"

#include <algorithm>

#include "nearest_wall.h"
#include "parallel.h"

namespace halfdisk {
namespace {

constexpr std::uint64_t kChunkSamples = 1024;

/// What one chunk adds: some samples of one repeat, or whole repeats if they are short.
struct Chunk {
    Statistics samples;
    Statistics repeats;
    Rgb direct{0.0}, indirect{0.0};  // sums over samples
    std::uint64_t rays = 0, cut = 0;
    bool endsRepeat = false;  // the last part of a repeat that takes several chunks
};

/// A repeat none of whose samples was finite has no mean.
void addMean(Statistics& repeats, const Statistics& repeat) {
    if (repeat.count > 0) repeats.add(repeat.mean);
}

template <class Observer>
Estimate run(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
             const EstimateOptions& options, Observer& observer) {
    const bool covered = isCovered(index, at);
    const std::uint32_t N = settings.samples;
    const std::uint64_t chunksPerRepeat = (N + kChunkSamples - 1) / kChunkSamples;
    const std::uint64_t repeatsPerChunk = std::max<std::uint64_t>(1, kChunkSamples / N);
    const std::uint64_t chunks = chunksPerRepeat > 1
                                     ? options.repeats * chunksPerRepeat
                                     : (options.repeats + repeatsPerChunk - 1) / repeatsPerChunk;

    const auto addSamples = [&](Chunk& chunk, std::uint64_t repeat, std::uint32_t first, std::uint32_t last) {
        Statistics mine;
        for (std::uint32_t n = first; n < last; ++n) {
            Irradiance E;
            if (!covered)
                E = gatherInOpen(index, at, settings, options.firstRepeat + repeat, {n, n + 1, N}, observer,
                                 chunk.rays);
            mine.add(E.total());
            if (!isFinite(E.total())) continue;
            chunk.direct += E.direct;
            chunk.indirect += E.indirect;
        }
        chunk.samples.merge(mine);
        return mine;
    };

    const auto work = [&](std::uint64_t c) {
        Chunk chunk;
        if (chunksPerRepeat > 1) {
            const std::uint64_t part = c % chunksPerRepeat;
            const auto first = static_cast<std::uint32_t>(part * kChunkSamples);
            addSamples(chunk, c / chunksPerRepeat, first,
                       static_cast<std::uint32_t>(std::min<std::uint64_t>(first + kChunkSamples, N)));
            chunk.endsRepeat = part + 1 == chunksPerRepeat;
        } else {
            const std::uint64_t end = std::min((c + 1) * repeatsPerChunk, options.repeats);
            for (std::uint64_t r = c * repeatsPerChunk; r < end; ++r)
                addMean(chunk.repeats, addSamples(chunk, r, 0, N));
        }
        return chunk;
    };

    Estimate estimate;
    Statistics openRepeat;
    const auto merge = [&](const Chunk& chunk) {
        estimate.samples.merge(chunk.samples);
        estimate.repeats.merge(chunk.repeats);
        estimate.direct += chunk.direct;
        estimate.indirect += chunk.indirect;
        estimate.rays += chunk.rays;
        if (chunksPerRepeat == 1) return;
        openRepeat.merge(chunk.samples);
        if (!chunk.endsRepeat) return;
        addMean(estimate.repeats, openRepeat);
        openRepeat = {};
    };
    forChunksInOrder(chunks, options.threads, options.cancelled, work, merge);

    const double count = std::max(1.0, static_cast<double>(estimate.samples.count));
    estimate.direct /= count;
    estimate.indirect /= count;
    return estimate;
}

/// How near a point must be to a wall to be on it: 1e-9 of the largest coordinate around.
double onWallDistance(const Scene& scene, Vec2 P) {
    double extent = std::max(std::abs(P.x), std::abs(P.y));
    for (const Segment& s : scene.segments)
        extent = std::max({extent, std::abs(s.a.x), std::abs(s.a.y), std::abs(s.b.x), std::abs(s.b.y)});
    return 1e-9 * extent;
}

bool sameDirection(Vec2 u, Vec2 v) {
    return glm::length(u - v) < 1e-9;
}

/// The wall that P is on; where several meet, one that stands across `normal` if there is one.
NearestWall wallAt(const SegmentIndex& index, Vec2 P, std::optional<Vec2> normal) {
    const Scene& scene = index.scene();
    const double within = onWallDistance(scene, P);
    const NearestWall nearest = nearestWall(scene, P);
    if (nearest.distance > within) return {};
    for (std::uint32_t i = 0; normal && i < scene.segments.size(); ++i) {
        if (!sameDirection(*normal, index.normal(i)) && !sameDirection(*normal, -index.normal(i))) continue;
        const NearestWall candidate = nearestOn(scene, i, P);
        if (candidate.distance <= within) return candidate;
    }
    return nearest;
}

Rgb albedoOf(const SegmentIndex& index, std::uint32_t segment) {
    const auto* diffuse = std::get_if<Diffuse>(&index.material(segment));
    return diffuse ? diffuse->albedo : Rgb(0.0);
}

ShadedPoint frontOf(const SegmentIndex& index, std::uint32_t segment, double t) {
    return {index.pointOn(segment, t), index.normal(segment), segment, albedoOf(index, segment)};
}

std::optional<ShadedPoint> placeOf(const SegmentIndex& index, Vec2 P, std::optional<Vec2> normal) {
    if (normal) normal = glm::normalize(*normal);
    const NearestWall wall = wallAt(index, P, normal);
    const bool onWall = wall.segment != kNoSegment;
    if (!normal && !onWall) return std::nullopt;
    if (!onWall) return ShadedPoint{P, *normal};

    const ShadedPoint front = frontOf(index, wall.segment, wall.t);
    if (!normal || sameDirection(*normal, front.N)) return front;
    if (sameDirection(*normal, -front.N)) return ShadedPoint{front.P, -front.N, front.segment, front.albedo};
    // A tilted half-disk reaches below the wall: stand clearly on its side and let the wall block what is
    // below.
    const double side = glm::dot(*normal, front.N) < 0.0 ? -1.0 : 1.0;
    return ShadedPoint{front.P + front.N * (side * index.originShift(wall.segment)), *normal};
}

std::uint32_t mediumInFrontOf(const SegmentIndex& index, const ShadedPoint& at) {
    return mediumAt(index, at.segment == kNoSegment ? at.P : originOff(index, at.segment, at.P, at.N));
}

}  // namespace

Estimate estimateIrradiance(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
                            const EstimateOptions& options) {
    if (options.cancelled) {
        CancelObserver observer{{}, options.cancelled};
        return run(index, at, settings, options, observer);
    }
    NoObserver observer;
    return run(index, at, settings, options, observer);
}

double raysPerRepeat(const SegmentIndex& index, const Settings& settings) {
    const double N = settings.samples;
    const double deltas = static_cast<double>(index.scene().lights.size());
    const double drawn =
        settings.emitters == Emitters::hit ? 0.0 : static_cast<double>(index.emitters().size());
    double gathers = N,
           rays = 0.0;  // at depth 0 each sample is gathered by itself and asks the delta lights again
    for (std::uint32_t depth = 0; depth <= settings.maxDepth; ++depth) {
        const double samplesEach = depth == 0 ? 1.0 : N;
        rays += gathers * (samplesEach * (1.0 + drawn) + deltas);
        gathers = std::pow(N, depth + 1.0);
    }
    return rays;
}

std::optional<ShadedPoint> shadedPointAt(const SegmentIndex& index, Vec2 P, std::optional<Vec2> normal) {
    auto at = placeOf(index, P, normal);
    if (at) at->medium = mediumInFrontOf(index, *at);
    return at;
}

ShadedPoint shadedPointOn(const SegmentIndex& index, std::uint32_t segment, double t) {
    ShadedPoint at = frontOf(index, segment, t);
    at.medium = mediumInFrontOf(index, at);
    return at;
}

Rgb outgoingRadiance(const SegmentIndex& index, const ShadedPoint& at, const Rgb& irradiance,
                     DefectSet defects) {
    const Segment& wall = index.scene().segments[at.segment];
    return wall.emission + irradiance * at.albedo / (defects.has(Defect::albedo) ? kPi : 2.0);
}

}  // namespace halfdisk
