// Which keys does the reader have, and what do they do? The help lists them, and so does the list of all that
// can be done.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace halfdisk {

enum class KeyRow : std::uint8_t {
    find,
    nextStep,
    previousStep,
    nextLesson,
    reset,
    alongRun,
    tenAlong,
    play,
    speed,
    ends,
    wholeRun,
    samples,
    point,
    depth,
    seed,
    samplerEmitters,
    defects,
    answer,
    unlock,
    fit,
    camera,
    panes,
    grid,
    edit,
    history,
    selected,
    choosing,
    nudge,
    files,
    share,
    exporting,
    pictures,
    pixel,
    size,
    help,
    mouse,
    exactNumber
};

struct KeyHelp {
    KeyRow row;
    std::string_view keys;  ///< several that do different things: two spaces between them
    std::string_view meaning;
};

inline constexpr std::array kKeyHelp{
    KeyHelp{KeyRow::find, "Ctrl K", "find anything by its name, and do it"},
    KeyHelp{KeyRow::nextStep, "Page Down, N", "next step of the lesson"},
    KeyHelp{KeyRow::previousStep, "Page Up, B", "previous step of the lesson"},
    KeyHelp{KeyRow::nextLesson, "L", "next lesson"},
    KeyHelp{KeyRow::reset, "R", "reset to how the step began"},
    KeyHelp{KeyRow::alongRun, "\u2192  \u2190", "step forward / back through the run"},
    KeyHelp{KeyRow::tenAlong, "Shift \u2192  \u2190", "ten steps at once"},
    KeyHelp{KeyRow::play, "Space", "play or pause"},
    KeyHelp{KeyRow::speed, "K  J", "play faster / slower"},
    KeyHelp{KeyRow::ends, "Home  End", "first / last step of the run"},
    KeyHelp{KeyRow::wholeRun, "W", "show the whole run at once"},
    KeyHelp{KeyRow::samples, "\u2191  \u2193", "double / halve N, when unlocked"},
    KeyHelp{KeyRow::point, "[  ]", "move P along its wall, when unlocked"},
    KeyHelp{KeyRow::depth, "D  Shift D", "one scattering more / fewer, when unlocked"},
    KeyHelp{KeyRow::seed, "S", "next seed, when unlocked"},
    KeyHelp{KeyRow::samplerEmitters, "M  E", "next sampler / emitters, when unlocked"},
    KeyHelp{KeyRow::defects, "1 ... 7  0", "switch one defect / all of them, when unlocked"},
    KeyHelp{KeyRow::answer, "A", "show the answer to the question"},
    KeyHelp{KeyRow::unlock, "U", "unlock all controls, or lock them again"},
    KeyHelp{KeyRow::fit, "F", "fit the scene into the canvas"},
    KeyHelp{KeyRow::camera, "+  -  Ctrl arrows", "magnify, shrink or move the picture"},
    KeyHelp{KeyRow::panes, "P  C", "on small screens: the next pane / code or canvas"},
    KeyHelp{KeyRow::grid, "G", "grid on / off"},
    KeyHelp{KeyRow::edit, "X", "change the scene, or be done with it"},
    KeyHelp{KeyRow::history, "Ctrl Z  Ctrl Y", "undo / redo a change of the scene"},
    KeyHelp{KeyRow::selected, "Ctrl D  Delete", "copy / delete what is selected"},
    KeyHelp{KeyRow::choosing, "Ctrl A  T", "editing: select all / next; Shift click: one more"},
    KeyHelp{KeyRow::nudge, "Arrows", "editing: move what is selected; Shift: further"},
    KeyHelp{KeyRow::files, "Ctrl S  Ctrl O", "save the scene / open a file, or one of the last"},
    KeyHelp{KeyRow::share, "Ctrl C  Ctrl V", "copy all that is seen as a text / paste such a text"},
    KeyHelp{KeyRow::exporting, "Ctrl E", "export what is seen: pictures, tables, the run, its words"},
    KeyHelp{KeyRow::pictures, "V  Shift V", "what the eye sees / the field of light on / off"},
    KeyHelp{KeyRow::pixel, ",  .", "the eye's strip: into a pixel, then left / right; Esc: back"},
    KeyHelp{KeyRow::size, "Ctrl +  Ctrl -", "everything larger / smaller"},
    KeyHelp{KeyRow::help, "? or F1", "this help"},
    KeyHelp{KeyRow::mouse, "Mouse", "drag P; drag the canvas to pan; wheel to zoom"},
    KeyHelp{KeyRow::exactNumber, "Double click", "on a number: type it exactly"},
};

/// The n-th of a row's keys: of "Ctrl Z  Ctrl Y" "Ctrl Z" and "Ctrl Y"; empty if there are fewer.
constexpr std::string_view keyOf(KeyRow row, std::size_t n = 0) {
    std::string_view keys = kKeyHelp[static_cast<std::size_t>(row)].keys;
    for (; n > 0; --n) {
        const std::size_t gap = keys.find("  ");
        keys = gap == std::string_view::npos ? std::string_view() : keys.substr(gap + 2);
    }
    return keys.substr(0, keys.find("  "));
}

static_assert(
    [] {
        for (std::size_t i = 0; i < kKeyHelp.size(); ++i)
            if (kKeyHelp[i].row != static_cast<KeyRow>(i)) return false;
        return kKeyHelp.back().row == KeyRow::exactNumber;
    }(),
    "a row for each, in their order");

}  // namespace halfdisk
