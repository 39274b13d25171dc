// How is a lesson file read and checked?
//
// A lesson is lessons/NN-slug.toml:
//
//   title = "Gather"
//   section = "heading of the published lesson that it teaches"
//   scene = "scenes/gather.toml"   # relative to the lesson file
//
//   [defaults]                     # what every step starts from: the same keys as [step.set]
//
//   [[term]]                       # explained on hover where prose has [radiance]
//   name = "radiance"
//   meaning = "..."
//
//   [[step]]
//   title = "Stand at P"
//   prose = """..."""              # markup: see prose.h
//   listing = [16, 17]             # lines of the published listing to highlight
//   show = ["halfdisk", "rays"]    # kViews
//   unlock = "samples"             # one of kControls
//   [step.set]                     # samples, depth, seed, sampler, emitters, at = "floor:0.25",
//   samples = 64                   # asPrinted = ["frame", "pdf"] or true, event
//   estimator = "photon-map"       # what makes the pictures (eye, field, profile), with its own
//   params = { photons = 20000 }   # parameters; without it what serves each picture best
//   scale = "log"                  # of the field: one of kFieldScales
//   run = "path"                   # whose run is recorded and stepped through, one of kRuns
//   against = { estimator = "path", params = { ... }, depth = 0 }   # beside it, for comparison
//   pixel = 100                    # of the eye's strip, whose run is recorded instead of that at P
//   pixelOf = "B"                  # one of kSides: the strip of the estimator or of the one against it
//   [step.goal]                    # what to reach by trying; the panel tells when it is
//   says = "Put P where the caustic is brightest."
//   reach = "profile"              # one of kGoalQuantities
//   atLeast = 3                    # or atMost; of "line": lines = [18, 19], any of which is right
//   [step.question]
//   ask = "..."
//   answer = "..."
//   [[step.claim]]                 # checked by halfdisk verify; measured as the step is set
//   name = "noise"                 # texts show its number: {noise}; see named_numbers.h
//   says = "..."
//   measure = "variance"           # one of kQuantities
//   with = { samples = 8 }         # what differs from the step: its keys, specular, estimator, params,
//                                  # repeats
//   over = { sampler = "lobe" }    # divided by the same, measured with these changes to `with`
//   atLeast = 10                   # or atMost, or equals (with tolerance = 0.01)
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lessons/input_error.h"
#include "lessons/lesson.h"

namespace halfdisk {

/// How parseLesson gets the scene that a lesson names; throws InputError.
using SceneLoader = std::function<SceneDescription(const std::filesystem::path&)>;

/// Reads TOML; `file` gives the number and the slug and where its scene is looked for. Throws InputError at
/// the first thing that is wrong; errors within the scene file carry that file's name.
Lesson parseLesson(std::string_view text, const std::filesystem::path& file, const SceneLoader& sceneLoader);

/// Reads a lesson file and its scene file. Throws InputError.
Lesson loadLesson(const std::filesystem::path& file);

struct LessonFileName {
    int number;
    std::string slug;
};

/// NN-slug.toml taken apart, or nothing if the name has another form. A slug is never a number alone.
std::optional<LessonFileName> parseLessonFileName(const std::filesystem::path& file);

}  // namespace halfdisk
