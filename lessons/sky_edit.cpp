#include "lessons/sky_edit.h"

namespace halfdisk {

SkyKind kindOf(const Sky& sky) {
    if (!sky.image.empty()) return SkyKind::image;
    if (!sky.light.strip.empty()) return SkyKind::strip;
    return sky.light.radiance == Rgb(0.0) ? SkyKind::none : SkyKind::even;
}

void setKind(Sky& sky, SkyKind kind) {
    if (kind == kindOf(sky) || kind == SkyKind::image) return;
    Environment& light = sky.light;
    if (light.radiance == Rgb(0.0)) light.radiance = Rgb(1.0);
    sky.image.clear();
    if (kind == SkyKind::none) light.radiance = Rgb(0.0);
    if (kind != SkyKind::strip) light.strip.clear();
    if (kind == SkyKind::strip && light.strip.empty()) light.strip.assign(4, Rgb(1.0));
}

}  // namespace halfdisk
