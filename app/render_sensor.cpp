// Where in the scene is the light of a picture measured? The sensor, from what was typed and the scene.
#include "app/render_sensor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli_arguments.h"
#include "app/wall_names.h"
#include "lessons/scene_keys.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kStripWidth = 512, kStripHeight = 64, kProfileBins = 64, kFieldWidth = 256;
constexpr double kMarginOfField = 0.05;  // of the scene's larger side, on each side

constexpr NumberInfo kWidthInfo{"width", "W", "", 1, kMostPictureWidth, kStripWidth};
constexpr NumberInfo kHeightInfo{"height", "H", "", 1, kMostPictureWidth, kStripHeight};

std::uint32_t sizeOr(const NumberInfo& info, const std::optional<std::string>& text, std::uint32_t initial) {
    if (!text) return initial;
    return static_cast<std::uint32_t>(wholeArgument(fmt::format("--{}", info.name), *text, info));
}

PictureOf sized(Sensor sensor, std::uint32_t width, std::uint32_t height) {
    if (std::uint64_t{width} * height > kMostPicturePixels)
        throw InputError(
            fmt::format("--width, --height: {} x {} pixels are too many, expected at most {} in all", width,
                        height, kMostPicturePixels));
    return {std::move(sensor), width, height};
}

Eye eyeOf(const RenderTexts& texts, const Scene& scene) {
    if (!scene.eye && !(texts.position && texts.direction))
        throw InputError(fmt::format(
            "{}: the scene has no eye, expected a table [eye] in it, or --position X,Y and --direction X,Y",
            texts.scene));
    Eye eye = scene.eye.value_or(Eye{});
    if (texts.position) eye.position = pointArgument("--position", *texts.position);
    if (texts.direction) eye.direction = directionArgument("--direction", *texts.direction);
    if (!texts.fov) return eye;
    const std::optional<double> fov = parseNumber(*texts.fov);
    if (!fov || *fov < kFovRule.least || *fov > kFovRule.most)
        failArgument("--fov", *texts.fov, fmt::format("is no field of view, expected {}", kFovRule.expected));
    eye.fov = *fov * (kPi / 180.0);
    return eye;
}

PictureOf stripOf(const RenderTexts& texts, const Scene& scene) {
    const std::uint32_t width = sizeOr(kWidthInfo, texts.width, kStripWidth);
    return sized(EyeStrip{eyeOf(texts, scene), width}, width,
                 sizeOr(kHeightInfo, texts.height, kStripHeight));
}

PictureOf profileOf(const RenderTexts& texts, const Scene& scene) {
    if (scene.segments.empty())
        throw InputError(fmt::format("{}: the scene has no wall, expected one at least", texts.scene));
    const std::uint32_t bins = sizeOr(kWidthInfo, texts.width, kProfileBins);
    return sized(Profile{wallsArgument("--walls", texts.walls, scene), bins}, bins,
                 sizeOr(kHeightInfo, texts.height, kStripHeight));
}

/// Around all that has a place, with a margin. Throws where nothing has one.
Field fieldAround(const RenderTexts& texts, const Scene& scene) {
    Vec2 min{kInfinity}, max{-kInfinity};
    const auto include = [&](Vec2 P) {
        min = glm::min(min, P);
        max = glm::max(max, P);
    };
    for (const Segment& wall : scene.segments) {
        include(wall.a);
        include(wall.b);
    }
    for (const DeltaLight& light : scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light)) include(point->position);
    if (!(std::max(max.x - min.x, max.y - min.y) > 0.0))
        throw InputError(
            fmt::format("{}: the scene has no extent, expected --min X,Y and --max X,Y", texts.scene));
    const Vec2 margin(kMarginOfField * std::max(max.x - min.x, max.y - min.y));
    return {.min = min - margin, .max = max + margin};
}

PictureOf fieldOf(const RenderTexts& texts, const Scene& scene) {
    Field field = texts.min && texts.max ? Field{} : fieldAround(texts, scene);
    if (texts.min) field.min = pointArgument("--min", *texts.min);
    if (texts.max) field.max = pointArgument("--max", *texts.max);
    const Vec2 extent = field.max - field.min;
    if (!(extent.x > 0.0 && extent.y > 0.0))
        throw InputError(
            fmt::format("--min, --max: from ({:g}, {:g}) to ({:g}, {:g}) is no area, expected a "
                        "corner at the lower left and one at the upper right",
                        field.min.x, field.min.y, field.max.x, field.max.y));
    field.width = sizeOr(kWidthInfo, texts.width, kFieldWidth);
    const double square = std::clamp(std::round(field.width * (extent.y / extent.x)), 1.0,
                                     static_cast<double>(kMostPictureWidth));
    field.height = sizeOr(kHeightInfo, texts.height, static_cast<std::uint32_t>(square));
    return sized(field, field.width, field.height);
}

}  // namespace

PictureOf pictureOf(const RenderRequest& request, const Scene& scene) {
    switch (request.sensor) {
        case PictureSensor::eye:
            return stripOf(request.texts, scene);
        case PictureSensor::profile:
            return profileOf(request.texts, scene);
        case PictureSensor::field:
            break;
    }
    return fieldOf(request.texts, scene);
}

}  // namespace halfdisk
