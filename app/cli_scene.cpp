// halfdisk scene check, halfdisk scene write: is a scene file usable, what is in it, and what is its
// canonical form?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "app/cli_actions.h"
#include "app/cli_commands.h"
#include "app/cli_output.h"
#include "app/render_output.h"
#include "core/cover.h"
#include "core/estimate.h"
#include "core/extremes/float_fit.h"
#include "lessons/scene_file.h"
#include "lessons/scene_keys.h"

namespace halfdisk {
namespace {

struct Extent {
    Vec2 min{kInfinity}, max{-kInfinity};
};

struct SceneCounts {
    std::string file, title;
    std::uint64_t segments = 0;
    std::array<std::uint64_t, kShapeKinds.size()> shapes{};           ///< written in the file
    std::array<std::uint64_t, kShapeKinds.size()> segmentsByShape{};  ///< that they consist of
    std::size_t materials = 0;
    std::array<std::uint64_t, kLightTypes.size()> lights{};
    std::size_t emitters = 0;
    IndexMethod method{};  ///< by which its walls are found
    InstructionSet instructions{};
    std::optional<Extent> bounds;  ///< of the walls
    FloatFit inFloat;              ///< what single precision would do to them
    std::array<std::uint64_t, kMaterialTypes.size()> materialsByType{};
    std::string environment;  ///< in words
    std::optional<Eye> eye;
    std::vector<std::string> hidden;  ///< lamps that lie behind a wall in the same place, told in words
};

/// Lamps, the fronts of which lie behind a wall in the same place (cover.h), as far as a look at 64 places of
/// each tells.
std::vector<std::string> hiddenLamps(const SegmentIndex& index) {
    constexpr int kPlaces = 64;
    std::vector<std::string> hidden;
    const Scene& scene = index.scene();
    const CoveredWalls covers(index, index.emitters());
    for (const std::uint32_t lamp : covers.all()) {
        int covered = 0;
        std::uint32_t by = kNoSegment;
        for (int i = 0; i < kPlaces; ++i) {
            const std::uint32_t over = wallOver(index, shadedPointOn(index, lamp, (i + 0.5) / kPlaces));
            if (over == kNoSegment) continue;
            ++covered;
            by = over;
        }
        if (covered > 0)
            hidden.push_back(fmt::format("\"{}\" lies on \"{}\", which is written before it and hides {}",
                                         scene.segmentNames[lamp], scene.segmentNames[by],
                                         covered == kPlaces ? "it" : "a part of it"));
    }
    return hidden;
}

std::string environmentWords(const Environment& environment) {
    if (environment.radiance == Rgb(0.0)) return "black";
    if (environment.strip.empty()) return "constant";
    return fmt::format("a strip of {} angles", environment.strip.size());
}

SceneCounts countScene(const std::string& file) {
    const SceneDescription description = loadScene(file);
    const Scene scene = expandScene(description);
    const SegmentIndex index(scene);  // throws for what no ray could meet

    SceneCounts counts;
    counts.file = file;
    counts.title = scene.title;
    counts.segments = scene.segments.size();
    for (const Shape& shape : description.shapes) {
        ++counts.shapes[shape.geometry.index()];
        counts.segmentsByShape[shape.geometry.index()] += edgeCount(shape.geometry);
    }
    counts.materials = scene.materials.size();
    for (const DeltaLight& light : scene.lights) ++counts.lights[light.index()];
    counts.emitters = index.emitters().size();
    counts.method = index.method();
    counts.instructions = index.instructions();
    for (const Material& material : scene.materials) ++counts.materialsByType[material.index()];
    counts.environment = environmentWords(scene.environment);
    counts.eye = scene.eye;
    counts.hidden = hiddenLamps(index);
    counts.inFloat = floatFitOf(scene);
    for (const Segment& s : scene.segments) {
        Extent& extent = counts.bounds ? *counts.bounds : counts.bounds.emplace();
        extent.min = glm::min(extent.min, glm::min(s.a, s.b));
        extent.max = glm::max(extent.max, glm::max(s.a, s.b));
    }
    return counts;
}

/// Why it is as well that every hit is decided in double.
std::string precisionWords(const FloatFit& inFloat) {
    if (inFloat.holds()) return "float would hold its walls; hits are decided in double";
    return fmt::format(
        "float would move ends by up to {:.1e} m: {} off by 1e-4 of their length, {} gone; hits are "
        "decided in double",
        inFloat.rounding, inFloat.bent, inFloat.lost);
}

Json sceneJson(const SceneCounts& counts) {
    Json object;
    object["file"] = counts.file;
    object["title"] = counts.title;
    object["segments"] = counts.segments;
    for (std::size_t i = 0; i < kShapeKinds.size(); ++i)
        object["segmentsByShape"][std::string(kShapeKinds[i])] = counts.segmentsByShape[i];
    object["materials"] = counts.materials;
    for (const auto& type : kLightTypes) object["lights"][std::string(type.name)] = counts.lights[type.value];
    object["emitters"] = counts.emitters;
    object["index"] = nameOf(kIndexMethods, counts.method);
    object["instructions"] = nameOf(kInstructionSets, counts.instructions);
    object["float"] = Json{{"rounding", jsonOf(counts.inFloat.rounding)},
                           {"bentWalls", counts.inFloat.bent},
                           {"lostWalls", counts.inFloat.lost}};
    object["bounds"] = nullptr;
    if (counts.bounds)
        object["bounds"] = Json{{"min", jsonOf(counts.bounds->min)}, {"max", jsonOf(counts.bounds->max)}};
    for (const auto& type : kMaterialTypes)
        object["materialsByType"][std::string(type.name)] = counts.materialsByType[type.value];
    object["environment"] = counts.environment;
    object["eye"] = nullptr;
    if (counts.eye) object["eye"] = Json{{"position", jsonOf(counts.eye->position)}};
    object["hiddenLamps"] = counts.hidden;
    return object;
}

std::string counted(std::uint64_t count, std::string_view noun) {
    const std::string_view plural = noun.ends_with("x") || noun.ends_with("s") ? "es" : "s";
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : plural);
}

std::string tableOf(const SceneCounts& counts) {
    std::string shapes, lights, materials;
    for (const auto& type : kMaterialTypes)
        if (counts.materialsByType[type.value] > 0)
            materials += fmt::format("{}{} {}", materials.empty() ? "" : ", ",
                                     counts.materialsByType[type.value], type.name);
    for (std::size_t i = 0; i < kShapeKinds.size(); ++i)
        if (counts.shapes[i] > 0)
            shapes += fmt::format("  {:<11} {} of {}\n", "", counted(counts.segmentsByShape[i], "segment"),
                                  counted(counts.shapes[i], kShapeKinds[i]));
    for (const auto& type : kLightTypes)
        lights += fmt::format("{}{} {}", lights.empty() ? "" : ", ", counts.lights[type.value], type.name);
    std::string table = fmt::format("{}: a usable scene\n", counts.file);
    if (!counts.title.empty()) table += fmt::format("  {:<11} {}\n", "title", counts.title);
    table += fmt::format("  {:<11} {}\n{}", "segments", counts.segments, shapes);
    table += fmt::format("  {:<11} found by {}, {}\n", "", nameOf(kIndexMethods, counts.method),
                         nameOf(kInstructionSets, counts.instructions));
    table += fmt::format("  {:<11} {}\n", "precision", precisionWords(counts.inFloat));
    table += fmt::format("  {:<11} {}\n", "materials", materials.empty() ? "none" : materials);
    table += fmt::format("  {:<11} {}\n", "lights", lights);
    table += fmt::format("  {:<11} {}\n", "emitters", counted(counts.emitters, "segment"));
    table += fmt::format("  {:<11} {}\n", "environment", counts.environment);
    if (counts.eye)
        table += fmt::format("  {:<11} at {:.9g}, {:.9g}\n", "eye", counts.eye->position.x,
                             counts.eye->position.y);
    for (const std::string& lamp : counts.hidden) table += fmt::format("  {:<11} {}\n", "WARNING", lamp);
    if (counts.bounds) {
        const auto& [min, max] = *counts.bounds;
        table += fmt::format("  {:<11} x {:.9g} to {:.9g} m, y {:.9g} to {:.9g} m\n", "bounds", min.x, max.x,
                             min.y, max.y);
    }
    return table;
}

int runCheck(const std::string& file, bool asJson) {
    const SceneCounts counts = countScene(file);
    if (asJson) {
        writeJson(sceneJson(counts));
    } else {
        writeOutput(tableOf(counts));
    }
    return kExitSuccess;
}

int runWrite(const std::string& file, const std::string& output) {
    const SceneDescription scene = loadScene(file);
    refuseUnwritable(output);
    saveScene(scene, output);
    return kExitSuccess;
}

void addCheck(CLI::App& scene, Action& chosen) {
    struct Texts {
        std::string file;
        bool json = false;
    };
    const auto texts = std::make_shared<Texts>();
    CLI::App* command = scene.add_subcommand("check", "validate a scene file; print its counts and bounds");
    command->add_option("FILE", texts->file, "scene file (TOML)")->required()->type_name("");
    command->add_flag("--json", texts->json, "print one JSON object");
    command->footer(
        "A file that cannot be used: one message with file, line and column on stderr, exit code 2.\n\n"
        "Example:\n  halfdisk scene check room.toml");
    command->callback([&chosen, texts] { chosen = [texts] { return runCheck(texts->file, texts->json); }; });
}

void addWrite(CLI::App& scene, Action& chosen) {
    struct Texts {
        std::string file, output;
    };
    const auto texts = std::make_shared<Texts>();
    CLI::App* command = scene.add_subcommand("write", "load a scene file and save it in its canonical form");
    command->add_option("FILE", texts->file, "scene file (TOML)")->required()->type_name("");
    command->add_option("-o,--output", texts->output, "file to write; may be FILE itself")
        ->type_name("OUT")
        ->required();
    command->footer(
        "Keys stand in one order, those at their default are left out, comments are lost.\n\n"
        "Example:\n  halfdisk scene write draft.toml -o room.toml");
    command->callback(
        [&chosen, texts] { chosen = [texts] { return runWrite(texts->file, texts->output); }; });
}

}  // namespace

void addSceneCommand(CLI::App& app, Action& chosen) {
    CLI::App* scene = app.add_subcommand("scene", "check a scene file, or write it in its canonical form");
    scene->require_subcommand(1);
    addCheck(*scene, chosen);
    addWrite(*scene, chosen);
    scene->footer(
        "Examples:\n  halfdisk scene check room.toml --json\n  halfdisk scene write draft.toml -o "
        "room.toml");
}

}  // namespace halfdisk
