// What does a scene require, for one sensor and one tolerance? What follows from the scene, what short runs
// in it say, and the plan that does just that.
//
// What is left out because it can't be there is left out by proof. Between ways that all carry everything
// the choice is by measurement. Only the numbers of bounces and of mirror and glass events drop light, and
// say how much.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "core/requirements/patch_bounces.h"
#include "core/requirements/pilot.h"
#include "core/requirements/requirement.h"
#include "core/requirements/scene_facts.h"

namespace halfdisk {

inline constexpr double kInitialTolerance = 0.01;

/// How far it is, 0 ... 1, and what is looked at.
using RequirementsTold = std::function<void(double share, std::string_view what)>;

struct RequirementsQuestion {
    const SegmentIndex& index;
    const Sensor& sensor;
    double tolerance = kInitialTolerance;  ///< share of the light at the sensor that may be missing or noise
    std::vector<Forced> forced{};
    std::uint64_t seed = kSeedInfo.initial;
    StopQuestion stop{};
    double effort = 1.0;      ///< rays cast to find out, in parts of the usual number
    RequirementsTold told{};  ///< may be empty
};

/// A kind of path: which light comes by it.
struct PathType {
    std::string_view word;  ///< of L, D, S and E
    std::string_view meaning;
    bool exists = false;
};

/// A way that finds all light, to be followed deep.
struct Series {
    Plan plan;
    std::uint32_t deepest;    ///< a multiple of 3
    double rays = 100'000.0;  ///< of the deepest run
};

/// What is known of chains of mirror and glass events.
struct SpecularFindings {
    std::uint32_t required = 0;
    /// By paths, ascending; `depth` counts events in a row. Empty: geometry bounds them, or there is no
    /// light.
    std::vector<BeyondDepth> measured;
    std::optional<BeyondDepth> missing{};  ///< what the plan's number leaves out, as far as it was measured
};

/// What is known of the bounces, from three sides.
struct BounceFindings {
    std::uint32_t required = 0;             ///< by itself, whatever is forced
    double tolerance = kInitialTolerance;   ///< that they may leave out
    bool dark = false;                      ///< no path that was tried brought any light: nothing is known
    std::uint32_t depth = 0;                ///< the plan's
    std::optional<std::uint32_t> byAlbedo;  ///< bound by the largest albedo; none: it is 1
    std::optional<PatchBounces> patches;    ///< of matt rooms
    std::optional<std::uint32_t> byRadius;  ///< bound by the spectral radius
    std::vector<BeyondDepth> measured;      ///< by paths, ascending in depth
    std::optional<BeyondDepth> missing{};   ///< what the plan's depth leaves out, as far as it is known
};

/// A way that was tried.
struct Candidate {
    Plan plan;
    Pilot pilot;
    bool chosen = false;
    bool lacks = false;  ///< brings surely less light than another
};

/// No way of carrying light does what is forced.
struct NoWay : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

struct RequirementsAnswer {
    SceneFacts facts;
    std::vector<PathType> pathTypes;
    std::vector<Requirement> requirements;  ///< in the order of kRequirements
    std::optional<Series> series;           ///< none: no way finds all light, or there is none
    SpecularFindings specular;
    BounceFindings bounces;
    std::vector<Candidate> candidates;
    /// Rays that left walls, and those of them that met no other.
    struct Escapes {
        std::uint32_t tried = 0, left = 0;
    };
    Escapes escapes;
    Plan plan;
    bool dark = false;  ///< no short run of any way brought light to the sensor: the plan is a guess
    std::string loses;  ///< empty, or what the plan can't carry, in words
    double tolerance = kInitialTolerance;
    std::uint64_t rays = 0;  ///< cast to find all this
    double seconds = 0.0;

    const Requirement& of(RequirementId id) const { return requirements[static_cast<std::size_t>(id)]; }
};

/// Whether there is a lamp, a light or an environment that shines.
inline bool hasLight(const RequirementsAnswer& answer) {
    return answer.facts.traits.delta || answer.facts.traits.area;
}

/// How badly the short run of the plan knows its light.
struct RareLight {
    double share = 0.0;    ///< relative standard error, or the part that it has not met
    bool isUnmet = false;  ///< the latter: patches know of it
};

/// Where light is so rare that what is measured is a rough guess.
std::optional<RareLight> rareLight(const RequirementsAnswer& answer);

/// Throws std::invalid_argument, with words for the user, for sensors that can't be used, and if no way does
/// what is forced; Stopped if question.stop says so.
RequirementsAnswer requirementsOf(const RequirementsQuestion& question);

/// The same into an answer that is there already: when it throws, what was found until then stays (facts and
/// path types always; the ways that were tried, without a plan).
void findRequirements(const RequirementsQuestion& question, RequirementsAnswer& answer);

/// The same with other things forced, faster: what is known of the scene stays. The other parts of the
/// question must be as they were.
RequirementsAnswer replanned(const RequirementsQuestion& question, const RequirementsAnswer& known);

/// Whether the ways of a plan are what this requires to be on (1), off (0), or so many.
std::uint32_t valueIn(const Plan& plan, RequirementId id, const SceneTraits& traits,
                      const SegmentIndex& index);

}  // namespace halfdisk
