// What is taken hold of when several things are? They move, turn and grow together.
#pragma once

#include <optional>
#include <vector>

#include "lessons/scene_edit.h"

namespace halfdisk {

/// Things in the order in which they were chosen, none twice. The last one is the primary one: what has only
/// one place on the screen shows that.
struct Selection {
    std::vector<Thing> things;

    Selection() = default;
    Selection(std::nullopt_t) {}           // NOLINT: nothing
    Selection(Thing one) : things{one} {}  // NOLINT: one thing
    Selection(std::optional<Thing> one) {  // NOLINT: or none
        if (one) things.push_back(*one);
    }

    bool empty() const { return things.empty(); }
    std::size_t size() const { return things.size(); }
    bool has(Thing thing) const;
    std::optional<Thing> primary() const { return empty() ? std::nullopt : std::optional(things.back()); }
    /// The only one; none if there are several.
    std::optional<Thing> single() const { return size() == 1 ? primary() : std::nullopt; }

    /// Becomes the primary one.
    void add(Thing thing);
    void drop(Thing thing);
    void toggle(Thing thing);
    bool operator==(const Selection&) const = default;
};

Selection everything(const SceneDescription& scene);

/// What lies wholly between two opposite corners (m).
Selection within(const SceneDescription& scene, Vec2 corner, Vec2 opposite);

/// Without what the scene does not have.
Selection existing(const SceneDescription& scene, const Selection& things);

/// The mean of the things' own middles (m), which turning and scaling leave where it is. What is nowhere
/// does not count.
Vec2 commonMiddle(const SceneDescription& scene, const Selection& things);

void moveBy(SceneDescription& scene, const Selection& things, Vec2 by);

/// About their common middle, counter-clockwise.
void turnBy(SceneDescription& scene, const Selection& things, double degrees);

/// About their common middle; factor > 0.
void scaleBy(SceneDescription& scene, const Selection& things, double factor);

/// Front and back of each change places.
void flip(SceneDescription& scene, const Selection& things);

void remove(SceneDescription& scene, const Selection& things);

/// Adds copies, moved; the eye is only moved. Returns what was added.
Selection copyOf(SceneDescription& scene, const Selection& things, Vec2 by);

/// Of all shapes among them; empty: the default one.
void setMaterial(SceneDescription& scene, const Selection& things, const std::string& material);

}  // namespace halfdisk
