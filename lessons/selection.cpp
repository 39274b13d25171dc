#include "lessons/selection.h"

#include <algorithm>
#include <array>

#include "lessons/shape_edges.h"
#include "lessons/shape_edit.h"

namespace halfdisk {
namespace {

/// What turning and scaling do not move (m); of a light that comes from everywhere there is none.
std::optional<Vec2> middleOf(const SceneDescription& scene, Thing thing) {
    if (thing.kind == ThingKind::shape) return middleOf(scene.shapes.at(thing.index).geometry);
    if (thing.kind == ThingKind::eye) return scene.eye->position;
    if (const auto* point = std::get_if<PointLight>(&scene.lights.at(thing.index))) return point->position;
    return std::nullopt;
}

/// Does something to each about its own middle, and brings that to where `place` says.
void aboutMiddle(SceneDescription& scene, const Selection& things, const auto& change, const auto& place) {
    const Vec2 common = commonMiddle(scene, things);
    for (const Thing thing : things.things) {
        const std::optional<Vec2> own = middleOf(scene, thing);
        change(thing);
        if (own) moveBy(scene, thing, place(*own - common) - (*own - common));
    }
}

/// Lights and the eye by where they stand.
bool isWithin(const SceneDescription& scene, Thing thing, Vec2 least, Vec2 most) {
    const auto inside = [&](Vec2 p) {
        return p.x >= least.x && p.x <= most.x && p.y >= least.y && p.y <= most.y;
    };
    if (thing.kind != ThingKind::shape) {
        const std::optional<Vec2> place = middleOf(scene, thing);
        return place && inside(*place);
    }
    const std::vector<Edge> edges = edgesOf(scene.shapes.at(thing.index).geometry);
    return std::all_of(edges.begin(), edges.end(),
                       [&](const Edge& edge) { return inside(edge.a) && inside(edge.b); });
}

}  // namespace

bool Selection::has(Thing thing) const {
    return std::find(things.begin(), things.end(), thing) != things.end();
}

void Selection::add(Thing thing) {
    drop(thing);
    things.push_back(thing);
}

void Selection::drop(Thing thing) {
    things.erase(std::remove(things.begin(), things.end(), thing), things.end());
}

void Selection::toggle(Thing thing) {
    if (has(thing))
        drop(thing);
    else
        add(thing);
}

Selection everything(const SceneDescription& scene) {
    Selection all;
    all.things = thingsOf(scene);
    return all;
}

Selection within(const SceneDescription& scene, Vec2 corner, Vec2 opposite) {
    const Vec2 least = glm::min(corner, opposite), most = glm::max(corner, opposite);
    Selection found;
    for (const Thing thing : thingsOf(scene))
        if (isWithin(scene, thing, least, most)) found.things.push_back(thing);
    return found;
}

Selection existing(const SceneDescription& scene, const Selection& things) {
    Selection there;
    std::array<std::vector<bool>, 3> seen;  // in one go, for they may be very many
    for (const Thing thing : things.things) {
        if (!exists(scene, thing)) continue;
        std::vector<bool>& ofKind = seen[static_cast<std::size_t>(thing.kind)];
        if (ofKind.size() <= thing.index) ofKind.resize(thing.index + 1);
        if (ofKind[thing.index]) continue;
        ofKind[thing.index] = true;
        there.things.push_back(thing);
    }
    return there;
}

Vec2 commonMiddle(const SceneDescription& scene, const Selection& things) {
    Vec2 sum(0.0);
    double count = 0.0;
    for (const Thing thing : things.things) {
        const std::optional<Vec2> own = middleOf(scene, thing);
        if (!own) continue;
        sum += *own;
        count += 1.0;
    }
    return count > 0.0 ? sum / count : sum;
}

void moveBy(SceneDescription& scene, const Selection& things, Vec2 by) {
    for (const Thing thing : things.things) moveBy(scene, thing, by);
}

void turnBy(SceneDescription& scene, const Selection& things, double degrees) {
    const Vec2 unit = unitAtDegrees(degrees);
    aboutMiddle(
        scene, things, [&](Thing thing) { turnBy(scene, thing, degrees); },
        [&](Vec2 way) { return turned(way, unit); });
}

void scaleBy(SceneDescription& scene, const Selection& things, double factor) {
    aboutMiddle(
        scene, things, [&](Thing thing) { scaleBy(scene, thing, factor); },
        [&](Vec2 way) { return factor * way; });
}

void flip(SceneDescription& scene, const Selection& things) {
    for (const Thing thing : things.things) flip(scene, thing);
}

void remove(SceneDescription& scene, const Selection& things) {
    // From the last one on, so that the numbers of the others stay.
    std::vector<Thing> last = things.things;
    std::sort(last.begin(), last.end(), [](Thing a, Thing b) { return a.index > b.index; });
    for (const Thing thing : last) remove(scene, thing);
}

Selection copyOf(SceneDescription& scene, const Selection& things, Vec2 by) {
    Selection copies;
    for (const Thing thing : things.things) copies.things.push_back(copyOf(scene, thing, by));
    return copies;
}

void setMaterial(SceneDescription& scene, const Selection& things, const std::string& material) {
    for (const Thing thing : things.things)
        if (thing.kind == ThingKind::shape) scene.shapes.at(thing.index).material = material;
}

}  // namespace halfdisk
