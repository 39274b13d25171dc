// Which typefaces, sizes and characters does the screen show?
#pragma once

#include <string>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace halfdisk {

/// Where the font files lie; see assets/fonts.cmake.
struct FontFiles {
    std::string prose, strong, emphasis, symbols, code, formula;
};

/// The files found when the program was built.
FontFiles installedFontFiles();

/// Heights of a line at scale 1, in pixels; the capital letters are about 0.6 of it.
inline constexpr float kProsePixels = 20, kCodePixels = 16, kTitlePixels = 27, kFormulaPixels = 21;

/// What a font is called elsewhere.
struct TypeFace {
    const ImFont* font = nullptr;
    std::string family;  ///< of its first file, which has nearly all of its characters
    bool bold = false, italic = false;
    float em = 0.0f;      ///< pixels: the size that CSS asks for
    float ascent = 0.0f;  ///< pixels from the top of a line to its baseline
};

/// Never null. Owned by the atlas; valid until the fonts are loaded again.
struct Fonts {
    ImFont* prose = nullptr;      ///< also ImGui's default font
    ImFont* strong = nullptr;     ///< prose in bold
    ImFont* emphasis = nullptr;   ///< prose in italics
    ImFont* code = nullptr;       ///< monospaced
    ImFont* title = nullptr;      ///< large and bold
    ImFont* formula = nullptr;    ///< with serifs
    std::string problem;          ///< empty, or which files could not be used and what is shown instead
    std::vector<TypeFace> faces;  ///< of those that come from a file
};

/// Of any font; without a family if it comes from no file.
TypeFace faceOf(const Fonts& fonts, const ImFont* font);

/// Replaces all fonts of `atlas` and rasterises them for `uiScale` (1 ... 3 and more). A missing or broken
/// file is replaced by the next best; `problem` says so. The renderer must upload the atlas afterwards.
Fonts loadFonts(ImFontAtlas& atlas, float uiScale, const FontFiles& files = installedFontFiles());

}  // namespace halfdisk
