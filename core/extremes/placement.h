// Where does a copy of a scene stand, and how large is it? The same scene elsewhere, with the same light.
#pragma once

#include "core/scene.h"

namespace halfdisk {

/// A copy's largest side is `scale` times what it was, and its middle is `offset` such sizes away from the
/// origin.
struct Placement {
    double scale = 1.0;
    double offset = 0.0;  ///< 0: where it was
};

/// Around all walls; empty (both 0) if there is none.
struct SceneBox {
    Vec2 least{0.0}, most{0.0};  ///< m
    Vec2 middle() const { return (least + most) / 2.0; }
};
SceneBox boxOf(const Scene& scene);

/// The larger side (m) of that box; 1 if there is none.
double sizeOf(const Scene& scene);

/// By how much (m) every point is moved before it is scaled.
Vec2 shiftOf(const Scene& scene, const Placement& placement);

/// Point lights shine and glass absorbs so that all irradiance stays as it was.
Scene placed(const Scene& scene, const Placement& placement);

}  // namespace halfdisk
