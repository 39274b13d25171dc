// What is a lesson: its steps, what each shows and sets, and the one control that it unlocks?
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/settings.h"
#include "lessons/claim.h"
#include "lessons/goal.h"
#include "lessons/instruments.h"
#include "lessons/maker.h"
#include "lessons/prose.h"
#include "lessons/scene_description.h"
#include "lessons/wall_point.h"

namespace halfdisk {

/// What a step can show on the canvas and beside it.
enum class View : std::uint8_t {
    halfdisk,
    rays,
    tree,
    integrand,
    error,
    histogram,
    code,
    exact,
    numbers,
    grid,
    damage,
    eye,
    field,
    profile,
    paths,
    samples,
    difference,
    strategies,
    trade,
    extremes,
    requirements
};

/// What a step can unlock for the reader's hand.
enum class Control : std::uint8_t {
    point,
    samples,
    depth,
    seed,
    sampler,
    emitters,
    defects,
    step,
    estimator,
    params
};

inline constexpr std::array<Named<View>, 21> kViews{{
    {View::halfdisk, "halfdisk", "the half-disk over P; with rays, also the sample points on its arc"},
    {View::rays, "rays", "the sample rays, coloured by what they bring back"},
    {View::tree, "tree", "the rays of the recursion, fading with depth"},
    {View::integrand, "integrand", "the light that arrives at P against \u03b8"},
    {View::error, "error", "the error against N"},
    {View::histogram, "histogram", "the histogram of the contributions"},
    {View::code, "code", "the source of castRay with the current line lit"},
    {View::exact, "exact", "the exact value beside the estimate"},
    {View::numbers, "numbers", "the estimate, its standard error and the count of rays"},
    {View::grid, "grid", "a grid behind the scene"},
    {View::damage, "damage", "what each defect of the published listing, alone, does to E"},
    {View::eye, "eye", "the strip that the scene's eye sees"},
    {View::field, "field", "the picture of the room: the light that passes every place"},
    {View::profile, "profile", "the light that arrives along P's wall"},
    {View::paths, "paths", "ways that light takes from the lamps, wall by wall"},
    {View::samples, "samples", "the list of all samples of the run, with what each brings"},
    {View::difference, "difference",
     "how the eye's strip and the light along P's wall differ from the exact ones"},
    {View::strategies, "strategies",
     "every strategy (s, t) of paths from both ends, with its share of the light"},
    {View::trade, "trade", "what accuracy costs: the error of every estimator against its rays"},
    {View::extremes, "extremes",
     "the scene moved to an extreme, and what leaks, hits itself or is not finite there"},
    {View::requirements, "requirements", "what this scene requires, why, and what each part costs"},
}};

inline constexpr std::array<Named<Control>, 10> kControls{{
    {Control::point, "point", "drag P along the walls"},
    {Control::samples, "samples", "the number of samples N"},
    {Control::depth, "depth", "the depth of the recursion"},
    {Control::seed, "seed", "the seed of the random numbers"},
    {Control::sampler, "sampler", "how directions are drawn"},
    {Control::emitters, "emitters", "how light from emitting walls is counted"},
    {Control::defects, "defects", "the switches of the published listing's defects"},
    {Control::step, "step", "step through the recorded run, forward and back"},
    {Control::estimator, "estimator", "which estimator makes the pictures"},
    {Control::params, "params", "the parameters of the estimator that makes the pictures"},
}};

/// Whose run is recorded and stepped through: an estimator that tells every step.
enum class Run : std::uint8_t { castRay, path, light, photonMap, bidirectional };

inline constexpr std::array<Named<Run>, 5> kRuns{{
    {Run::castRay, "cast-ray", "the lesson's castRay: a tree of half-disks"},
    {Run::path, "path", "single paths from P, each asking one light at every wall"},
    {Run::light, "light", "paths from the lights, every wall joined to P"},
    {Run::photonMap, "photon-map", "photons from the lights, then looked up from P"},
    {Run::bidirectional, "bidirectional", "a path from P and one from a light, joined in every way"},
}};

/// Of two makers that are compared.
enum class Side : std::uint8_t { first, second };

inline constexpr std::array<Named<Side>, 2> kSides{{
    {Side::first, "A", "the first estimator"},
    {Side::second, "B", "the one that it is compared with"},
}};

/// How the picture of the room is coloured.
enum class FieldScale : std::uint8_t { light, logarithm, noise };

inline constexpr std::array<Named<FieldScale>, 3> kFieldScales{{
    {FieldScale::light, "light", "as bright as the light is"},
    {FieldScale::logarithm, "log", "false colours over four powers of ten: what is dim can be seen as well"},
    {FieldScale::noise, "noise",
     "false colours for how uncertain each place is: its standard error as a share of its light"},
}};

/// A set of views, bit k = entry k of kViews.
struct ViewSet {
    std::uint32_t bits = 0;

    constexpr bool has(View v) const { return (bits >> static_cast<unsigned>(v)) & 1u; }
    constexpr void set(View v, bool on) {
        const std::uint32_t bit = 1u << static_cast<unsigned>(v);
        bits = on ? bits | bit : bits & ~bit;
    }
    constexpr bool operator==(const ViewSet&) const = default;
    constexpr ViewSet operator-(ViewSet other) const { return {bits & ~other.bits}; }
    constexpr ViewSet operator&(ViewSet other) const { return {bits & other.bits}; }
};

/// Those that show light elsewhere than at P.
inline constexpr ViewSet kPictureSet = [] {
    ViewSet set;
    for (const View view :
         {View::eye, View::field, View::profile, View::paths, View::difference, View::strategies})
        set.set(view, true);
    return set;
}();

/// Those that measure the program itself on this scene.
inline constexpr ViewSet kInstrumentSet = [] {
    ViewSet set;
    for (const View view : {View::trade, View::extremes, View::requirements}) set.set(view, true);
    return set;
}();

/// Lines of the published listing, counted from 1.
inline constexpr int kListingLines = 34;

/// A lesson runs on a classroom's machine at every step: less than castRay itself would take.
inline constexpr std::uint64_t kMostLessonSamples = 4096;
inline constexpr std::uint64_t kMostLessonDepth = 8;

/// Of the strip that the window shows of what the scene's eye sees.
inline constexpr std::uint32_t kEyeStripPixels = 256;

/// All that a step sets; what neither it nor the lesson's [defaults] name is at its initial value.
struct StepValues {
    Settings settings;
    WallPoint at{0, 0.5};    ///< P, in the expanded scene; initially the middle of the first wall
    Makers makers;           ///< of the pictures: eye, field and profile
    Run run = Run::castRay;  ///< the one that is recorded
    FieldScale scale = FieldScale::light;
    InstrumentSettings instruments;
    std::uint32_t event = 0;               ///< position in the recorded run, 0 = its start
    std::optional<std::uint32_t> pixel{};  ///< of the eye's strip, whose run is recorded instead of that at P
    Side pixelOf = Side::first;            ///< whose strip the pixel is of, where two are compared
    bool operator==(const StepValues&) const = default;
};

struct Question {
    Prose ask;
    Prose answer;
    bool operator==(const Question&) const = default;
};

struct Step {
    std::string title;
    Prose prose;
    std::vector<int> listing;  ///< lines of the published listing to highlight, 1 ... kListingLines
    ViewSet show;
    std::optional<Control> unlock;
    StepValues values;
    std::optional<Goal> goal;
    std::optional<Question> question;
    std::vector<Claim> claims;
    bool operator==(const Step&) const = default;
};

struct Lesson {
    int number = 0;    ///< NN of the file name NN-slug.toml: its place in the course
    std::string slug;  ///< the rest: what scripts call it, also when numbers change
    std::string title;
    std::string section;  ///< heading of the published lesson that it teaches
    std::filesystem::path file, scenePath;
    SceneDescription scene;
    std::vector<Term> terms;
    std::vector<Step> steps;  ///< at least one
    bool operator==(const Lesson&) const = default;
};

}  // namespace halfdisk
