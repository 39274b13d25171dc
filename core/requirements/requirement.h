// What can a scene require of the program? The one table of requirements, and what is found of each.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace halfdisk {

enum class RequirementId : std::uint8_t {
    deltaLights,
    areaLights,
    environment,
    open,
    specular,
    glossy,
    bounces,
    lightSampling,
    mis,
    lightPass,
    photonPass,
    roulette,
    index,
    colour,
    doublePrecision
};

/// What may be said to `--force`.
enum class Switch : std::uint8_t {
    none,   ///< nothing: `fixed` tells why
    onOff,  ///< it is done, or not
    number  ///< so often at most; off: never
};

struct RequirementInfo {
    RequirementId id;
    std::string_view name;   ///< on the command line and in JSON
    std::string_view title;  ///< on the screen
    Switch kind;
    std::string_view asks;     ///< the question that is asked of the scene
    std::string_view fixed{};  ///< of Switch::none: why it can't be switched
};

inline constexpr std::string_view kSceneFact =
    "it is a fact of the scene, and what the scene lacks costs nothing: it is never met";

inline constexpr std::array<RequirementInfo, 15> kRequirements{{
    {RequirementId::deltaLights, "delta-lights", "Point and directional lights", Switch::none,
     "are there lights that no ray can meet by chance?", kSceneFact},
    {RequirementId::areaLights, "area-lights", "Lamps", Switch::none, "are there walls that emit?",
     kSceneFact},
    {RequirementId::environment, "environment", "Environment", Switch::none, "does light come from outside?",
     kSceneFact},
    {RequirementId::open, "open", "Open scene", Switch::none, "can light leave?", kSceneFact},
    {RequirementId::specular, "specular", "Mirror and glass events", Switch::number,
     "how many mirrors and skins of glass can light meet one after the other?"},
    {RequirementId::glossy, "glossy", "Glossy lobes", Switch::none,
     "do walls scatter more in some directions than in others?", kSceneFact},
    {RequirementId::bounces, "bounces", "Bounces", Switch::number,
     "how many scatterings still bring more than the tolerance?"},
    {RequirementId::lightSampling, "light-sampling", "Light sampling", Switch::onOff,
     "must lights be asked, or do rays find them by chance?"},
    {RequirementId::mis, "mis", "Weights (MIS)", Switch::onOff,
     "must two ways of finding the same light share it?"},
    {RequirementId::lightPass, "light-pass", "Paths from the lights", Switch::onOff,
     "is there light that paths from the sensor find badly, or never?"},
    {RequirementId::photonPass, "photon-pass", "Photon pass", Switch::onOff,
     "is there light that only stored photons can carry?"},
    {RequirementId::roulette, "roulette", "Russian roulette", Switch::onOff,
     "is it worth while to end paths by chance?"},
    {RequirementId::index, "index", "Index of walls", Switch::onOff,
     "are there so many walls that trying each one takes longer than looking them up?"},
    {RequirementId::colour, "colour", "Colour", Switch::none, "do lights or walls differ by channel?",
     "light is three numbers everywhere in the program, grey or not"},
    {RequirementId::doublePrecision, "double", "Double precision", Switch::none,
     "does single precision suffice to decide which wall is met?",
     "single precision only proposes walls, and double precision decides, in every scene"},
}};

constexpr const RequirementInfo& infoOf(RequirementId id) {
    return kRequirements[static_cast<std::size_t>(id)];
}

/// What decided.
enum class Ground : std::uint8_t {
    proof,        ///< it follows from the scene alone
    measurement,  ///< several complete ways were tried on the scene, and the best one was taken
    force         ///< the user wanted it
};

struct Requirement {
    RequirementId id;
    bool on = false;
    std::optional<std::uint32_t> number;  ///< of Switch::number
    Ground ground = Ground::proof;
    std::string reason;  ///< a sentence with its numbers
};

/// What the user wants in any case: 0 off, 1 on; of Switch::number how many, 0 none.
struct Forced {
    RequirementId id;
    std::uint32_t value = 0;
    bool operator==(const Forced&) const = default;
};

}  // namespace halfdisk
