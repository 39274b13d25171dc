// Which typefaces, sizes and characters does the screen show?
#include "app/fonts.h"

#include <ft2build.h>
#include <imgui.h>
#include <imgui_freetype.h>
#include FT_FREETYPE_H

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <iterator>

namespace halfdisk {

namespace {

// Pairs of first and last character, ended by 0. ImGui keeps the pointer until the atlas is built.
constexpr ImWchar kTextRanges[] = {0x0020, 0x017f,  // Latin
                                   0x0370, 0x03ff,  // Greek
                                   0x2010, 0x2027,  // dashes, quotes, ellipsis
                                   0x2070, 0x209c,  // superscripts and subscripts
                                   0xfffd, 0xfffd,  // shown for a character that no font has
                                   0};
constexpr ImWchar kSymbolRanges[] = {0x0020, 0x017f, 0x0370, 0x03ff,
                                     0x2010, 0x2027, 0x2030, 0x203a,  // per mille, primes, angle quotes
                                     0x2070, 0x209c, 0x1d43, 0x1d6a,  // raised and lowered letters
                                     0x2c7c, 0x2c7d,                  // lowered j
                                     0x2113, 0x2113,                  // script l
                                     0x2150, 0x215f,                  // fractions
                                     0x2190, 0x21ff,                  // arrows
                                     0x2200, 0x22ff,                  // operators
                                     0x25a0, 0x25ff,                  // geometric shapes
                                     0x2713, 0x2718,                  // check marks
                                     0x27e8, 0x27e9,                  // angle brackets
                                     0xfffd, 0xfffd, 0};

/// Empty if it cannot be read or does not start like a TrueType or OpenType font.
std::string readFont(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::string_view view = bytes;
    const bool known = view.starts_with("OTTO") || view.starts_with("true") || view.starts_with("ttcf") ||
                       view.starts_with(std::string_view("\0\1\0\0", 4));
    return known ? bytes : std::string();
}

/// What the file says of itself, for a font whose lines are `size` pixels high.
TypeFace faceOfFile(const std::string& bytes, float size) {
    TypeFace face;
    face.em = size;
    FT_Library library = nullptr;
    FT_Face opened = nullptr;
    if (FT_Init_FreeType(&library) != 0) return face;
    if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                           static_cast<FT_Long>(bytes.size()), 0, &opened) == 0) {
        const int line = opened->ascender - opened->descender;
        if (opened->family_name) face.family = opened->family_name;
        face.bold = (opened->style_flags & FT_STYLE_FLAG_BOLD) != 0;
        face.italic = (opened->style_flags & FT_STYLE_FLAG_ITALIC) != 0;
        if (line > 0) face.em = size * static_cast<float>(opened->units_per_EM) / static_cast<float>(line);
        FT_Done_Face(opened);
    }
    FT_Done_FreeType(library);
    return face;
}

struct Source {
    const std::string& path;
    const ImWchar* ranges;
};

/// One font made of several files: a character comes from the first file that has it. Null if no file is
/// usable.
ImFont* addFont(ImFontAtlas& atlas, float size, std::initializer_list<Source> sources, Fonts& fonts) {
    std::string& problem = fonts.problem;
    ImFont* font = nullptr;
    for (const Source& source : sources) {
        const std::string bytes = readFont(source.path);
        if (bytes.empty()) {
            if (problem.find(source.path) == std::string::npos)
                problem += (problem.empty() ? "cannot use the font " : ", ") + source.path;
            continue;
        }
        void* copy = IM_ALLOC(bytes.size());  // the atlas frees it
        std::memcpy(copy, bytes.data(), bytes.size());
        ImFontConfig config;
        config.MergeMode = font != nullptr;
        ImFont* added =
            atlas.AddFontFromMemoryTTF(copy, static_cast<int>(bytes.size()), size, &config, source.ranges);
        if (font) continue;
        font = added;
        fonts.faces.push_back(faceOfFile(bytes, size));
        fonts.faces.back().font = font;
    }
    return font;
}

ImFont* addDefaultFont(ImFontAtlas& atlas, float size) {
    ImFontConfig config;
    config.SizePixels = size;
    return atlas.AddFontDefault(&config);
}

Fonts addFonts(ImFontAtlas& atlas, float scale, const FontFiles& files) {
    const auto size = [scale](float pixels) { return std::round(pixels * scale); };
    const Source symbols{files.symbols, kSymbolRanges};
    Fonts fonts;
    fonts.prose = addFont(atlas, size(kProsePixels), {{files.prose, kTextRanges}, symbols}, fonts);
    if (!fonts.prose) {
        fonts.prose = addDefaultFont(atlas, size(kProsePixels));
        fonts.problem = "no usable font file; the built-in font is shown";
    }
    fonts.strong = addFont(atlas, size(kProsePixels), {{files.strong, kTextRanges}, symbols}, fonts);
    fonts.emphasis = addFont(atlas, size(kProsePixels), {{files.emphasis, kTextRanges}, symbols}, fonts);
    fonts.code = addFont(atlas, size(kCodePixels), {{files.code, kSymbolRanges}, symbols}, fonts);
    fonts.title = addFont(atlas, size(kTitlePixels), {{files.strong, kTextRanges}, symbols}, fonts);
    fonts.formula = addFont(atlas, size(kFormulaPixels), {{files.formula, kSymbolRanges}, symbols}, fonts);
    for (ImFont** font : {&fonts.strong, &fonts.emphasis, &fonts.code, &fonts.title, &fonts.formula})
        if (!*font) *font = fonts.prose;
    return fonts;
}

}  // namespace

FontFiles installedFontFiles() {
    return {HALFDISK_FONT_PROSE,   HALFDISK_FONT_STRONG, HALFDISK_FONT_EMPHASIS,
            HALFDISK_FONT_SYMBOLS, HALFDISK_FONT_CODE,   HALFDISK_FONT_FORMULA};
}

Fonts loadFonts(ImFontAtlas& atlas, float uiScale, const FontFiles& files) {
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    Fonts fonts = addFonts(atlas, uiScale, files);
    if (atlas.Build()) {
        for (TypeFace& face : fonts.faces) face.ascent = std::round(face.font->Ascent);
        return fonts;
    }
    atlas.Clear();
    ImFont* only = addDefaultFont(atlas, std::round(kProsePixels * uiScale));
    atlas.Build();
    return {only, only, only, only, only, only, "a font file is broken; the built-in font is shown", {}};
}

TypeFace faceOf(const Fonts& fonts, const ImFont* font) {
    for (const TypeFace& face : fonts.faces)
        if (face.font == font) return face;
    return {font, "", false, false, font->FontSize, std::round(font->Ascent)};
}

}  // namespace halfdisk
