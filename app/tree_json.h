// How is the recorded run of castRay written for other programs?
//
// One object. Lengths in m, angles in rad, radiance in W/(m rad), irradiance in W/m; colours are [red, green,
// blue]; what is not finite or does not apply is null.
//
//   lesson, step        the slug and the step, counted from 1; null for a scene by itself
//   settings            samples, depth, seed, sampler, emitters, defects (names), maxSpecular
//   point               wall, segment, t, P, N: where the run gathers
//   truncated           deeper steps were left out; those at depth 0 are all there
//   rays                cast in the run; refused: it would take so many that it was not begun
//   estimate            direct, indirect, total: E of this run; standardError, exact: or null
//   shownEvents         how many events the screen has passed; null: the whole run is shown
//   walls               names, by segment
//   run                 whose run it is: cast-ray, path, light, photon-map or bidirectional
//   divisor             of another run than castRay's: its estimate is the sum of all values, divided by this
//   pixel               of the eye's strip, counted from 0 at its left, if the run is its own: `estimate` and
//                       `value` are then its radiance, `exact` is null; null: the run is of P
//   unit                of `estimate`: W/m, or W/(m rad) of a pixel
//   calls               the tree of half-disks: call (its index), parent (the index of the call whose sample
//   led
//                       here, or null), sample (which of the parent's), depth, segment, P, N, firstEvent,
//                       lastEvent. None of another run.
//   events              in their order: event (its index), kind, line (of the published listing), depth,
//   call,
//                       n (which sample), light (which light), segment (the wall met, or null), theta (from
//                       the tangent), pdfAngle (1/rad), visible (the shadow ray got through), onward (it
//                       comes from a mirror or glass), missed (no wall: `to` is one metre along), from, to,
//                       direction, value (what came back, is added or is returned), sum (after this step). Of
//                       another run: event, kind, file and line (of the source), path, vertex (walls met so
//                       far), carried (radiance or power), segment, s, t, photons, radius (m), visible,
//                       missed, delta (a mirror's or glass's event), from, to, pdfAngle, weight (share of
//                       this way of finding the light), throughput, value, sum. Of fields that a kind does
//                       not speak of: 0, false, null.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

inline constexpr std::array<Named<EventKind>, 9> kEventKinds{{
    {EventKind::enter, "enter", "a half-disk begins to be gathered"},
    {EventKind::light, "light", "a light, or a point on one, is asked"},
    {EventKind::sample, "sample", "an angle is drawn"},
    {EventKind::direction, "direction", "it is rotated to the normal"},
    {EventKind::meet, "meet", "a ray meets a wall, or none"},
    {EventKind::arrival, "arrival", "light comes back along the ray"},
    {EventKind::accumulate, "accumulate", "it is weighed and added"},
    {EventKind::average, "average", "the sum is divided by N"},
    {EventKind::leave, "leave", "what the half-disk gathered is returned"},
}};

/// Of the state's answer; without one `events` and `calls` are empty. One event a line.
std::string treeJson(const AppState& state);

}  // namespace halfdisk
