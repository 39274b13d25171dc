#include "patches.h"

#include <algorithm>
#include <stdexcept>

#include "cover.h"
#include "wall_contacts.h"

namespace halfdisk {
namespace {

/// A lit side between two places where it is cut.
struct Stretch {
    std::uint32_t segment;
    bool front;
    double from, to;  // u
    double length;    // m
};

/// Where a side is cut: u, ascending. `contacts` as contactsOf gives them.
std::vector<double> cutsOf(std::uint32_t segment, bool front, std::vector<double> contacts,
                           std::span<const WallPlace> cuts) {
    constexpr double kApart = 1e-6;  // of the wall: the places are no surer
    for (const WallPlace& cut : cuts) {
        if (cut.segment != segment || cut.front != front) continue;
        const auto next = std::lower_bound(contacts.begin(), contacts.end(), cut.u);
        if (next == contacts.begin() || next == contacts.end()) continue;
        if (cut.u - *(next - 1) > kApart && *next - cut.u > kApart) contacts.insert(next, cut.u);
    }
    return contacts;
}

std::vector<Stretch> stretchesOf(const Visibility& visibility, std::span<const WallPlace> cuts,
                                 const StopQuestion& stop) {
    const SegmentIndex& index = visibility.index();
    std::vector<Stretch> stretches;
    for (std::uint32_t i = 0; i < index.scene().segments.size(); ++i) {
        throwIfStopped(stop, i);
        const Segment& wall = index.scene().segments[i];
        const std::vector<double> contacts = contactsOf(wall, visibility.corners());
        for (const bool front : {true, false}) {
            if (!front && !wall.twoSided) continue;
            const std::vector<double> places = cutsOf(i, front, contacts, cuts);
            for (std::size_t k = 0; k + 1 < places.size(); ++k)
                stretches.push_back(
                    {i, front, places[k], places[k + 1], index.length(i) * (places[k + 1] - places[k])});
        }
    }
    return stretches;
}

bool isHidden(const SegmentIndex& index, const Patch& patch) {
    const Vec2 N = perp(patch.b - patch.a) / patch.length;
    return isCovered(index, {(patch.a + patch.b) / 2.0, N, patch.segment});
}

}  // namespace

std::size_t litSides(const Scene& scene) {
    std::size_t sides = scene.segments.size();
    for (const Segment& wall : scene.segments) sides += wall.twoSided ? 1 : 0;
    return sides;
}

Patches::Patches(const Visibility& visibility, std::uint32_t wanted, const StopQuestion& stop)
    : Patches(visibility, PatchDivision{wanted}, stop) {}

Patches::Patches(const Visibility& visibility, const PatchDivision& division, const StopQuestion& stop) {
    const SegmentIndex& index = visibility.index();
    const std::vector<Stretch> stretches = stretchesOf(visibility, division.cuts, stop);
    if (division.times * stretches.size() > kMost)
        throw std::invalid_argument("the walls touch at so many places that they take " +
                                    std::to_string(division.times * stretches.size()) +
                                    " patches, expected at most " + std::to_string(kMost));
    double total = 0.0;
    for (const Stretch& stretch : stretches) total += stretch.length;
    const double spare =
        std::max(0.0, static_cast<double>(division.wanted) - static_cast<double>(stretches.size()));

    sides_.assign(2 * index.scene().segments.size(), {0, 0});
    for (const Stretch& stretch : stretches) {
        const Segment& wall = index.scene().segments[stretch.segment];
        const std::size_t count =
            division.times * (1 + static_cast<std::size_t>(spare * stretch.length / total));
        const auto uAt = [&](std::size_t k) {
            return k == count ? stretch.to
                              : stretch.from + (stretch.to - stretch.from) * static_cast<double>(k) /
                                                   static_cast<double>(count);
        };
        const auto pointAt = [&](double u) { return u == 1.0 ? wall.b : wall.a + u * (wall.b - wall.a); };
        Range& range = sides_[2 * stretch.segment + (stretch.front ? 0 : 1)];
        if (range.first == range.end) range = {patches_.size(), patches_.size()};
        for (std::size_t k = 0; k < count; ++k) {
            const double from = uAt(k), to = uAt(k + 1);
            Patch patch{pointAt(from), pointAt(to), stretch.segment, stretch.front, from, to};
            if (!stretch.front) std::swap(patch.a, patch.b);
            throwIfStopped(stop, k);
            patch.length = glm::length(patch.b - patch.a);
            patch.hidden = isHidden(index, patch);
            patches_.push_back(patch);
        }
        range.end = patches_.size();
    }
}

std::size_t Patches::at(std::uint32_t segment, bool front, double u) const {
    const Range range = of(segment, front);
    const auto begin = patches_.begin();
    const auto after = std::upper_bound(begin + static_cast<std::ptrdiff_t>(range.first) + 1,
                                        begin + static_cast<std::ptrdiff_t>(range.end), u,
                                        [](double place, const Patch& patch) { return place < patch.uFrom; });
    return static_cast<std::size_t>(after - begin) - 1;
}

}  // namespace halfdisk
