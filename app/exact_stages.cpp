#include "app/exact_stages.h"

#include <algorithm>
#include <stdexcept>

#include "app/picture_stages.h"
#include "core/exact_picture.h"
#include "core/patches.h"
#include "core/stop.h"

namespace halfdisk {
namespace {

constexpr std::size_t kIntegrandPoints = 361;
constexpr unsigned kDeepest = 8;
constexpr std::size_t kMostKnownPictures = 8;
// Of a field, by which its error is measured, and of the walls, whose own error is then some 0.01 % of the
// light.
constexpr std::size_t kCells = 400;
constexpr std::uint32_t kPatches = 800;

/// Ready for `depth`; null where there is none, or if cancelled on the way.
const Reference* referenceFor(const LightAnswer& answer, unsigned depth, ReferenceCache& cache,
                              const std::atomic<bool>& cancelled) {
    const PreparedScene& scene = *answer.asked.scene;
    if (!scene.visibility) return nullptr;
    if (depth > 1 && scene.scene.segments.size() > Reference::kMostWallsDeep) return nullptr;
    if (cache.scene != answer.asked.scene) cache = {};
    if (!cache.reference || cache.depth < depth) {
        cache.scene = answer.asked.scene;
        cache.depth = depth;
        cache.reference = std::make_unique<Reference>(scene.index, depth, &cancelled);
        if (!cache.reference->ready()) cache = {};
    }
    return cache.reference.get();
}

/// How often light is scattered in a picture of this maker; nothing: without end.
std::optional<unsigned> depthOf(const Maker& maker, const Settings& settings) {
    const EstimatorInfo& info = *findEstimator(maker.estimator);
    if (info.endless && info.endless(maker.params)) return std::nullopt;
    return maker.depth.value_or(settings.maxDepth);
}

/// Within one scene, which has one eye.
bool sameSensor(const Sensor& a, const Sensor& b) {
    const auto *profileA = std::get_if<Profile>(&a), *profileB = std::get_if<Profile>(&b);
    return a.index() == b.index() && (!profileA || profileA->segments == profileB->segments);
}

std::shared_ptr<const std::vector<Rgb>> picture(const LightAnswer& answer, const Sensor& sensor,
                                                unsigned depth, ReferenceCache& cache,
                                                const std::atomic<bool>& cancelled) {
    const Reference* reference = referenceFor(answer, depth + 1, cache, cancelled);
    if (!reference) return nullptr;
    for (const KnownPicture& known : cache.pictures)
        if (known.depth == depth && sameSensor(known.sensor, sensor)) return known.pixels;
    try {
        const StopQuestion stop = [&cancelled] { return cancelled.load(std::memory_order_relaxed); };
        auto pixels = std::make_shared<const std::vector<Rgb>>(exactPicture(*reference, sensor, depth, stop));
        if (cache.pictures.size() == kMostKnownPictures) cache.pictures.erase(cache.pictures.begin());
        cache.pictures.push_back({sensor, depth, pixels});
        return pixels;
    } catch (const Stopped&) {
        return nullptr;
    }
}

std::shared_ptr<const KnownCells> cells(const LightAnswer& answer, const Field& field,
                                        std::optional<unsigned> depth, ReferenceCache& cache,
                                        const std::atomic<bool>& cancelled) {
    const PreparedScene& scene = *answer.asked.scene;
    if (!scene.visibility || litSides(scene.scene) > kPatches) return nullptr;
    if (cache.scene != answer.asked.scene) {
        cache = {};
        cache.scene = answer.asked.scene;
    }
    for (const KnownField& known : cache.fields)
        if (known.depth == depth) return known.cells;
    try {
        const StopQuestion stop = [&cancelled] { return cancelled.load(std::memory_order_relaxed); };
        const Radiosity light(scene.index, kPatches, depth, stop);
        auto found = std::make_shared<const KnownCells>(exactCells(light, field, kCells, stop));
        if (cache.fields.size() == kMostKnownPictures) cache.fields.erase(cache.fields.begin());
        cache.fields.push_back({depth, found});
        return found;
    } catch (const Stopped&) {
        return nullptr;
    } catch (const std::invalid_argument&) {
        return nullptr;  // light that is never absorbed has no answer
    }
}

}  // namespace

void findExact(LightAnswer& answer, ReferenceCache& cache, const std::atomic<bool>& cancelled) {
    const unsigned depth = answer.asked.settings.maxDepth;
    if (depth > kDeepest) return;
    const Reference* reference = referenceFor(answer, depth, cache, cancelled);
    if (!reference) return;
    answer.exact = reference->irradiance(answer.point, depth);
    answer.integrand.clear();
    for (std::size_t i = 0; i < kIntegrandPoints; ++i) {
        const double theta = kPi * (static_cast<double>(i) + 0.5) / kIntegrandPoints;
        answer.integrand.push_back({theta, reference->radiance(answer.point, theta, depth)});
    }
}

void findExactPictures(LightAnswer& answer, ReferenceCache& cache, const std::atomic<bool>& cancelled) {
    const LightQuestion& asked = answer.asked;
    if (!asked.pictures.has(View::difference) && !asked.makers.second) return;
    for (const View view : {View::eye, View::profile}) {
        const std::optional<Sensor> sensor = asked.pictures.has(view) ? sensorOf(view, asked) : std::nullopt;
        for (std::size_t side = 0; sensor && side < 2; ++side) {
            const std::optional<Maker> maker = makerAsked(asked, view, side);
            const std::optional<unsigned> depth = maker ? depthOf(*maker, asked.settings) : std::nullopt;
            if (depth && *depth <= kDeepest && !cancelled)
                answer.exactPictures[side].of(view) = picture(answer, *sensor, *depth, cache, cancelled);
        }
    }
    if (!asked.makers.second || !asked.pictures.has(View::field)) return;
    const Sensor field = *sensorOf(View::field, asked);
    for (std::size_t side = 0; side < 2; ++side)
        if (const std::optional<Maker> maker = makerAsked(asked, View::field, side); maker && !cancelled)
            answer.exactPictures[side].field =
                cells(answer, std::get<Field>(field), depthOf(*maker, asked.settings), cache, cancelled);
}

std::optional<double> errorOf(const LightAnswer& answer, View view, std::size_t side) {
    const auto& picture = (side == 0 ? answer.pictures : answer.against).of(view);
    if (picture && view == View::field) {
        const auto& known = answer.exactPictures[side].field;
        if (!known || picture->film.passes == 0) return std::nullopt;
        return relativeError(picture->film.pixels.mean, *known, std::get<Field>(picture->sensor));
    }
    if (view != View::eye && view != View::profile) return std::nullopt;
    const auto& exact = answer.exactPictures[side].of(view);
    if (!picture || !exact) return std::nullopt;
    return relativeError(picture->film.pixels.mean, *exact);
}

}  // namespace halfdisk
