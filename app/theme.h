// Which colours and spacings does the screen have?
// Made for projectors: dark ink on paper. The hues derive from Okabe and Ito's palette, told apart with every
// common kind of colour blindness; those used for text are darkened until their contrast is at least 4.5 : 1
// on both grounds.
#pragma once

#include <imgui.h>

namespace halfdisk {

/// ImGui's packed colours (IM_COL32). Text: ink, inkSoft, accent, error, exact, estimate.
struct Palette {
    ImU32 background = IM_COL32(0xfb, 0xf9, 0xf4, 255);        ///< paper, behind everything
    ImU32 panel = IM_COL32(0xff, 0xff, 0xff, 255);             ///< behind text and fields
    ImU32 ink = IM_COL32(0x1a, 0x1a, 0x1a, 255);               ///< text
    ImU32 inkSoft = IM_COL32(0x55, 0x50, 0x4a, 255);           ///< secondary text
    ImU32 accent = IM_COL32(0x00, 0x5b, 0x8e, 255);            ///< links, terms, what can be moved
    ImU32 wallFront = IM_COL32(0x22, 0x22, 0x22, 255);         ///< the side that scatters
    ImU32 wallBack = IM_COL32(0xb5, 0xae, 0xa2, 255);          ///< the black, opaque side
    ImU32 glass = IM_COL32(0x3d, 0x8f, 0xb8, 255);             ///< skins of glass (blue)
    ImU32 mirror = IM_COL32(0x8a, 0x9b, 0xb0, 255);            ///< mirrors (silver)
    ImU32 light = IM_COL32(0xe6, 0x9f, 0x00, 255);             ///< sources (orange)
    ImU32 point = IM_COL32(0xd5, 0x5e, 0x00, 255);             ///< the shaded point P (vermillion)
    ImU32 normal = IM_COL32(0x00, 0x7a, 0x5a, 255);            ///< its normal (bluish green)
    ImU32 halfDisk = IM_COL32(0x56, 0xb4, 0xe9, 255);          ///< the half-disk over P (sky blue)
    ImU32 sample = IM_COL32(0x00, 0x72, 0xb2, 255);            ///< sample points on its arc (blue)
    ImU32 rayBright = IM_COL32(0xd9, 0x8c, 0x00, 255);         ///< a ray that brings much light
    ImU32 rayDark = IM_COL32(0x8b, 0x93, 0xa3, 255);           ///< a ray that brings none
    ImU32 shadowRayClear = IM_COL32(0x00, 0x9e, 0x73, 255);    ///< reaches the light
    ImU32 shadowRayBlocked = IM_COL32(0x7d, 0x22, 0x60, 255);  ///< hits a wall first (dark purple)
    ImU32 currentLine = IM_COL32(0xff, 0xec, 0x9e, 255);       ///< behind the line of code that runs
    ImU32 error = IM_COL32(0xb0, 0x2a, 0x1a, 255);             ///< messages of failure
    ImU32 exact = IM_COL32(0x00, 0x66, 0x9e, 255);             ///< values known exactly
    ImU32 estimate = IM_COL32(0xb0, 0x4a, 0x00, 255);          ///< values that were sampled
    ImU32 knob = IM_COL32(0x37, 0x8a, 0xb3, 255);              ///< of a slider, under its number
    ImU32 grid = IM_COL32(0xe2, 0xdc, 0xd0, 255);              ///< thin lines behind the scene
};

/// The same colour with `opacity` in 0 ... 1.
ImU32 withOpacity(ImU32 color, float opacity);

/// WCAG 2 contrast of two opaque colours, 1 ... 21; text needs 4.5.
double contrast(ImU32 a, ImU32 b);

/// Sets every colour and size of `style` for the scale.
void applyTheme(ImGuiStyle& style, float uiScale, const Palette& palette = {});

}  // namespace halfdisk
