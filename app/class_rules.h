// What may a class not touch? Set at the start, for the whole session.
#pragma once

#include <optional>
#include <string>

#include "lessons/lesson.h"

namespace halfdisk {

/// A column of the window that can be left out.
enum class Panel : std::uint8_t { lesson, controls };

inline constexpr std::array<Named<Panel>, 2> kPanels{{
    {Panel::lesson, "lesson", "the lesson's text, on the left"},
    {Panel::controls, "controls", "everything on the right"},
}};

struct ClassRules {
    std::uint16_t locked = 0;  ///< bit k = entry k of kControls: never unlocked
    ViewSet hidden;            ///< never shown
    bool withoutLesson = false, withoutControls = false;
    bool kiosk = false;  ///< no other lesson, no other file, no editing, no Unlock all

    // values that every step has instead of its own
    std::optional<std::uint32_t> samples, maxDepth;
    std::optional<std::uint64_t> seed;
    std::optional<Sampler> sampler;
    std::optional<Emitters> emitters;
    std::optional<DefectSet> defects;
    std::optional<std::string> point;  ///< NAME:T, where the scene has such a wall
    std::optional<std::string> estimator;

    bool isLocked(Control control) const { return (locked >> static_cast<unsigned>(control)) & 1u; }
    void lock(Control control) {
        locked = static_cast<std::uint16_t>(locked | (1u << static_cast<unsigned>(control)));
    }
};

/// `--lock CONTROL` or `--lock CONTROL=VALUE`. Throws InputError.
void addLock(ClassRules& rules, const std::string& text);

/// `--hide PANEL` or `--hide VIEW`. Throws InputError.
void addHidden(ClassRules& rules, const std::string& text);

/// A step's values as they are then. What the scene cannot do (a wall that it lacks) is left as it is.
void obey(const ClassRules& rules, const Scene& scene, StepValues& values);

}  // namespace halfdisk
