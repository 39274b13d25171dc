// In which order do the eye's strip and the field grow behind the frame? Batch by batch of passes, each one
// whole.
#include "app/picture_stages.h"

#include <algorithm>
#include <utility>

#include "app/cloud_stages.h"
#include "app/first_look.h"
#include "app/theme.h"
#include "core/estimators.h"

namespace halfdisk {
namespace {

/// Two pictures side by side show the same light in the same shade.
void share(std::shared_ptr<const LightPicture>& a, std::shared_ptr<const LightPicture>& b) {
    if (!a || !b || a->colors.empty() || b->colors.empty()) return;
    const double white = std::max(whiteOf(*a), whiteOf(*b));
    for (auto* picture : {&a, &b}) {
        if ((*picture)->white == white) continue;
        auto toned = std::make_shared<LightPicture>(**picture);
        tone(*toned, white);
        *picture = std::move(toned);
    }
}

}  // namespace

std::optional<Sensor> sensorOf(View view, const LightQuestion& asked) {
    const Bounds& bounds = asked.scene->bounds;
    switch (view) {
        case View::eye:
            return eyeStripOf(asked.scene->scene);
        case View::field:
            return fieldOf(bounds.min, bounds.max);
        default:
            return profileOf(asked.at.segment);
    }
}

std::optional<Maker> makerAsked(const LightQuestion& asked, View view, std::size_t side) {
    if (!asked.pictures.has(view)) return std::nullopt;
    if (side == 1) return asked.makers.second;
    return asked.makers.first ? *asked.makers.first : usualMaker(view);
}

namespace {

/// `work` as it must be to answer `asked`: made anew unless it does already. None if cancelled on the way.
void prepare(std::unique_ptr<PictureWork>& work, const LightQuestion& asked, View view, const Maker& maker,
             const std::atomic<bool>& cancelled) {
    if (work && work->answers(asked, maker)) return;
    work.reset();
    const std::optional<Sensor> sensor = sensorOf(view, asked);
    if (!sensor) return;
    try {
        work = std::make_unique<PictureWork>(asked, *sensor, maker, cancelled);
    } catch (const Stopped&) {
    }
}

/// One coarse pass of what will take long to prepare; null where that is quick, or if cancelled on the way.
std::shared_ptr<const LightPicture> firstLook(const LightQuestion& asked, View view, const Maker& maker,
                                              const std::atomic<bool>& cancelled) {
    const std::optional<Maker> look = firstLookOf(maker);
    const std::optional<Sensor> sensor = look ? sensorOf(view, asked) : std::nullopt;
    if (!sensor) return nullptr;
    try {
        PictureWork work(asked, coarse(*sensor), *look, cancelled);
        if (work.picture()->complete || !work.addBatch()) return nullptr;
        auto picture = std::make_shared<LightPicture>(*work.picture());
        picture->firstLook = true;
        return picture;
    } catch (const Stopped&) {
        return nullptr;
    }
}

/// One of the pictures that are asked for.
struct Wanted {
    std::size_t kind;  ///< in kPictureViews
    std::size_t side;
    Maker maker;

    View view() const { return kPictureViews[kind]; }
};

/// Those that are quick to prepare first.
std::vector<Wanted> wantedPictures(const LightQuestion& asked) {
    std::vector<Wanted> wanted;
    for (std::size_t kind = 0; kind < kPictureViews.size(); ++kind)
        for (std::size_t side = 0; side < 2; ++side)
            if (const std::optional<Maker> maker = makerAsked(asked, kPictureViews[kind], side))
                wanted.push_back({kind, side, *maker});
    std::stable_partition(wanted.begin(), wanted.end(),
                          [](const Wanted& one) { return !firstLookOf(one.maker); });
    return wanted;
}

bool isAbout(const std::optional<FollowedWays>& ways, const LightQuestion& asked) {
    return ways && ways->scene == asked.scene && ways->maxDepth == asked.settings.maxDepth &&
           ways->seed == asked.settings.seed;
}

FollowedWays followed(const LightQuestion& asked, const std::atomic<bool>& cancelled) {
    FollowedWays made{asked.scene, asked.settings.maxDepth, asked.settings.seed};
    made.ways = std::make_shared<const std::vector<LightWay>>(
        lightWays(asked.scene->index, kWaysFollowed, made.maxDepth, made.seed));
    made.words = countWords(*made.ways);
    if (const std::optional<Eye>& eye = asked.scene->scene.eye)
        made.throughPupil = countPassing(*made.ways, eye->position, kPupilRadius);
    const Palette palette;
    made.cloud =
        cloudOf(linesOf(*made.ways), asked.scene->bounds, {palette.rayBright, palette.sample}, cancelled);
    return made;
}

void showWays(LightAnswer& answer, const FollowedWays& ways) {
    answer.ways = ways.ways;
    answer.wayWords = ways.words;
    answer.throughPupil = ways.throughPupil;
    answer.wayCloud = ways.cloud;
}

}  // namespace

Maker usualMaker(View view) {
    return makerOf(view == View::field ? "light" : "path");
}

void recallPictures(LightAnswer& answer, PictureCache& cache) {
    for (std::size_t k = 0; k < kPictureViews.size(); ++k) {
        const View view = kPictureViews[k];
        for (std::size_t side = 0; side < 2; ++side) {
            const std::optional<Maker> maker = makerAsked(answer.asked, view, side);
            const auto& work = cache.works[k][side];
            auto& shown = (side == 0 ? answer.pictures : answer.against).of(view);
            if (!maker || !work || !work->answers(answer.asked, *maker)) continue;
            const bool begun = work->picture()->film.passes > 0 || work->picture()->complete;
            if (begun || !shown) shown = work->picture();
        }
        share(answer.pictures.of(view), answer.against.of(view));
    }
    if (answer.asked.pictures.has(View::paths) && isAbout(cache.ways, answer.asked))
        showWays(answer, *cache.ways);
    recallStrategies(answer, cache.strategies);
}

void refinePictures(LightAnswer& answer, PictureCache& cache, const std::atomic<bool>& cancelled,
                    const std::function<void()>& publish, unsigned turns) {
    const LightQuestion& asked = answer.asked;
    const std::vector<Wanted> wanted = wantedPictures(asked);
    for (const Wanted& one : wanted) {
        const auto& work = cache.works[one.kind][one.side];
        auto& shown = (one.side == 0 ? answer.pictures : answer.against).of(one.view());
        if (shown || (work && work->answers(asked, one.maker))) continue;
        shown = firstLook(asked, one.view(), one.maker, cancelled);
        if (!shown) continue;
        share(answer.pictures.of(one.view()), answer.against.of(one.view()));
        publish();
    }
    bool strategies = prepareStrategies(asked, cache.strategies, cancelled);
    recallPictures(answer, cache);  // also what refuses
    if (asked.pictures.has(View::paths) && !answer.ways) {
        if (!isAbout(cache.ways, asked)) cache.ways = followed(asked, cancelled);
        if (!cache.ways->cloud) return cache.ways.reset();  // cancelled
        showWays(answer, *cache.ways);
        publish();
    }
    for (bool growing = true; growing && turns > 0; --turns) {
        growing = false;
        for (const Wanted& one : wanted) {
            std::unique_ptr<PictureWork>& work = cache.works[one.kind][one.side];
            prepare(work, asked, one.view(), one.maker, cancelled);
            if (!work) continue;  // cancelled, or there is no such sensor
            if (!work->picture()->complete) {
                if (cancelled || !work->addBatch()) return;
                growing = true;
            } else if (answer.pictures.of(one.view()) == work->picture() ||
                       answer.against.of(one.view()) == work->picture()) {
                continue;
            }
            recallPictures(answer, cache);
            publish();
        }
        if (!strategies) continue;
        if (cancelled || !cache.strategies->addBatch()) return;
        strategies = !cache.strategies->grid()->complete;
        growing = true;
        recallStrategies(answer, cache.strategies);
        publish();
    }
}

}  // namespace halfdisk
