// Through which cells of a field does a flight go, and how far in each?
#pragma once

#include <cmath>

#include "sensor.h"

namespace halfdisk {

/// Calls visit(pixel, from, to) for each cell that the ray (unit direction) crosses within `distance` metres,
/// in order; from and to are metres along the ray. Amanatides & Woo 1987, "A fast voxel traversal algorithm
/// for ray tracing".
template <class Visit>
void forCells(const Field& field, const Ray& ray, double distance, const Visit& visit) {
    const Vec2 cell = (field.max - field.min) / Vec2(field.width, field.height);
    double enter = 0.0, exit = distance;
    for (int axis = 0; axis < 2; ++axis) {
        const double speed = ray.direction[axis], place = ray.origin[axis];
        if (speed == 0.0) {
            if (place < field.min[axis] || place >= field.max[axis]) return;
            continue;
        }
        const double a = (field.min[axis] - place) / speed, b = (field.max[axis] - place) / speed;
        enter = std::max(enter, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    if (!(enter < exit)) return;

    const glm::dvec2 size{field.width, field.height};
    const Vec2 start = (ray.origin + enter * ray.direction - field.min) / cell;
    int at[2], step[2];
    double next[2], stride[2];
    for (int axis = 0; axis < 2; ++axis) {
        const double speed = ray.direction[axis];
        at[axis] = static_cast<int>(std::clamp(std::floor(start[axis]), 0.0, size[axis] - 1.0));
        step[axis] = speed > 0.0 ? 1 : -1;
        stride[axis] = speed == 0.0 ? kInfinity : cell[axis] / std::abs(speed);
        const double edge = field.min[axis] + (at[axis] + (speed > 0.0 ? 1 : 0)) * cell[axis];
        next[axis] = speed == 0.0 ? kInfinity : (edge - ray.origin[axis]) / speed;
    }
    double from = enter;
    const int wide = static_cast<int>(field.width), high = static_cast<int>(field.height);
    while (from < exit) {
        const int axis = next[0] < next[1] ? 0 : 1;
        const double to = std::min(exit, next[axis]);
        // Row 0 is the top one.
        if (to > from) visit(static_cast<std::uint32_t>((high - 1 - at[1]) * wide + at[0]), from, to);
        from = std::max(from, to);
        at[axis] += step[axis];
        next[axis] += stride[axis];
        if (at[axis] < 0 || at[axis] >= (axis == 0 ? wide : high)) return;
    }
}

}  // namespace halfdisk
