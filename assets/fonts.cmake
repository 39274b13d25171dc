# Which font files does the program use? All come from Debian packages; none is kept in this repository.
#   Inter        prose: Latin and Greek
#   DejaVu Sans  what Inter lacks: integrals, operators, arrows, brackets
#   DejaVu Sans Mono for code, DejaVu Serif for formulas
function(halfdisk_find_font variable package file)
    find_file(${variable} ${file}
        PATHS /usr/share/fonts /usr/local/share/fonts
        PATH_SUFFIXES opentype/inter truetype/dejavu inter inter-fonts dejavu dejavu-sans-fonts TTF OTF
        NO_DEFAULT_PATH DOC "Font file ${file}")
    if(NOT ${variable})
        message(FATAL_ERROR "The font ${file} is missing: apt install ${package} (or set -D${variable}=/path/to/${file})")
    endif()
    mark_as_advanced(${variable})
endfunction()

halfdisk_find_font(HALFDISK_FONT_PROSE fonts-inter Inter-Regular.otf)
halfdisk_find_font(HALFDISK_FONT_STRONG fonts-inter Inter-Bold.otf)
halfdisk_find_font(HALFDISK_FONT_EMPHASIS fonts-inter Inter-Italic.otf)
halfdisk_find_font(HALFDISK_FONT_SYMBOLS fonts-dejavu-core DejaVuSans.ttf)
halfdisk_find_font(HALFDISK_FONT_CODE fonts-dejavu-core DejaVuSansMono.ttf)
halfdisk_find_font(HALFDISK_FONT_FORMULA fonts-dejavu-core DejaVuSerif.ttf)
