// Which place has each pixel of a picture, and what is said of its sensor?
#include <fmt/format.h>

#include <cmath>

#include "app/render_sensor.h"
#include "core/overload.h"

namespace halfdisk {
namespace {

constexpr double kDegrees = 180.0 / kPi;

double lengthOf(const Profile& profile, const SegmentIndex& index) {
    double length = 0.0;
    for (const std::uint32_t wall : profile.segments) length += index.length(wall);
    return length;
}

Json factsOf(const EyeStrip& strip) {
    return {{"position", jsonOf(strip.eye.position)},
            {"direction", jsonOf(strip.eye.direction)},
            {"fov", jsonOf(strip.eye.fov * kDegrees)},
            {"width", strip.width}};
}

Json factsOf(const Profile& profile, const SegmentIndex& index) {
    Json walls = Json::array();
    for (const std::uint32_t wall : profile.segments) walls.push_back(index.scene().segmentNames[wall]);
    return {{"walls", walls}, {"length", jsonOf(lengthOf(profile, index))}, {"width", profile.bins}};
}

Json factsOf(const Field& field) {
    return {{"min", jsonOf(field.min)},
            {"max", jsonOf(field.max)},
            {"width", field.width},
            {"height", field.height}};
}

}  // namespace

std::string_view unitOf(PictureSensor sensor) {
    return sensor == PictureSensor::eye ? "W/(m rad)" : "W/m";
}

Json sensorFacts(const PictureOf& picture, const SegmentIndex& index) {
    return std::visit(
        Overload{[](const EyeStrip& strip) { return factsOf(strip); },
                 [&](const Profile& profile) { return factsOf(profile, index); },
                 [](const Field& field) { return factsOf(field); }, [](const auto&) { return Json(); }},
        picture.sensor);
}

std::string sensorLine(const PictureOf& picture, const SegmentIndex& index) {
    return std::visit(
        Overload{[](const EyeStrip& strip) {
                     const Vec2 P = strip.eye.position, D = strip.eye.direction + 0.0;
                     return fmt::format(
                         "eye at ({:.6g}, {:.6g}) m, direction ({:.6g}, {:.6g}), {:g} degrees: {} pixels",
                         P.x, P.y, D.x, D.y, strip.eye.fov * kDegrees, strip.width);
                 },
                 [&](const Profile& profile) {
                     return fmt::format("profile of {} wall{}, {:.6g} m: {} bins", profile.segments.size(),
                                        profile.segments.size() == 1 ? "" : "s", lengthOf(profile, index),
                                        profile.bins);
                 },
                 [](const Field& field) {
                     return fmt::format("field from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m: {} x {} cells",
                                        field.min.x, field.min.y, field.max.x, field.max.y, field.width,
                                        field.height);
                 },
                 [](const auto&) { return std::string(); }},
        picture.sensor);
}

std::vector<std::string_view> placeColumns(const Sensor& sensor) {
    if (std::holds_alternative<EyeStrip>(sensor)) return {"angle"};
    if (std::holds_alternative<Profile>(sensor)) return {"s"};
    return {"x", "y"};
}

PixelPlaces::PixelPlaces(const Sensor& sensor, const SegmentIndex& index) : sensor_(sensor) {
    if (const auto* profile = std::get_if<Profile>(&sensor)) wallLength_ = lengthOf(*profile, index);
}

std::array<double, 2> PixelPlaces::at(std::uint32_t pixel) const {
    using Place = std::array<double, 2>;
    return std::visit(
        Overload{[&](const EyeStrip& strip) {
                     const double across = 2.0 * (pixel + 0.5) / strip.width - 1.0;
                     return Place{std::atan(across * std::tan(strip.eye.fov / 2.0)) * kDegrees};
                 },
                 [&](const Profile& profile) { return Place{(pixel + 0.5) / profile.bins * wallLength_}; },
                 [&](const Field& field) {
                     const double x = (pixel % field.width + 0.5) / field.width;
                     const double y = (pixel / field.width + 0.5) / field.height;
                     return Place{field.min.x + x * (field.max.x - field.min.x),
                                  field.max.y - y * (field.max.y - field.min.y)};
                 },
                 [](const auto&) { return Place{}; }},
        sensor_);
}

}  // namespace halfdisk
