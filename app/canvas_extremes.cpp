// Where do rays go wrong at an extreme? The slit that the dial puts into the scene, and some of the rays that
// the chosen tracer loses, drawn where they would be in the scene as it stands.
#include "app/canvas.h"
#include "app/lost_mark.h"

namespace halfdisk {

ImU32 lostColor(const Palette& palette, LostRay::How how) {
    return how == LostRay::How::leak      ? palette.error
           : how == LostRay::How::selfHit ? palette.shadowRayBlocked
                                          : palette.ink;
}

void drawLostMark(const Pen& list, const Palette& palette, LostRay::How how, ImVec2 at, float radius) {
    const ImU32 ink = lostColor(palette, how);
    const float thick = radius / 2.5f;
    switch (how) {
        case LostRay::How::leak:
            list.AddCircleFilled(at, radius, ink);
            return;
        case LostRay::How::selfHit:
            list.AddCircle(at, radius, ink, 0, thick);
            return;
        case LostRay::How::nonFinite:
            list.AddLine({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}, ink, thick);
            list.AddLine({at.x - radius, at.y + radius}, {at.x + radius, at.y - radius}, ink, thick);
            return;
    }
}

void drawExtremes(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    const auto& dial = state.answer ? state.answer->instruments.dial : nullptr;
    if (!state.shows(View::extremes) || !dial) return;
    const Palette& palette = canvas.ui.palette;
    for (const Segment& wall : dial->slit) canvas.line(wall.a, wall.b, palette.accent, canvas.px(3));
    for (const LostRay& ray : dial->chosen.lost) {
        // What is not a number goes nowhere.
        if (ray.how != LostRay::How::nonFinite)
            canvas.line(ray.from, ray.to, withOpacity(lostColor(palette, ray.how), 0.35f), canvas.px(1.2f));
    }
    for (const LostRay& ray : dial->chosen.lost)
        drawLostMark(canvas.list, palette, ray.how,
                     canvas.screen(ray.how == LostRay::How::leak ? ray.to : ray.from), canvas.px(3.0f));
}

}  // namespace halfdisk
