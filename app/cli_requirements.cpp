// halfdisk requirements: what must be modelled in a scene, and what need not?
#include <fmt/format.h>

#include <memory>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/cli_probe.h"
#include "app/render_sensor.h"
#include "app/requirements_arguments.h"
#include "app/requirements_json.h"
#include "app/requirements_text.h"
#include "lessons/scene_file.h"

namespace halfdisk {
namespace {

enum class Asked : std::uint8_t { eye, profile, field, probe };
constexpr std::array<Named<Asked>, 4> kAsked{{
    {Asked::eye, "eye", "what the scene's eye sees"},
    {Asked::profile, "profile", "the light along walls (--walls)"},
    {Asked::field, "field", "the light all over the plane"},
    {Asked::probe, "probe", "the light at a point (--at)"},
}};

struct RequirementsTexts {
    RenderTexts render;
    std::optional<std::string> sensor, at, normal;
    std::string tolerance = fmt::format("{}", kInitialTolerance);
    std::vector<std::string> force;
    std::string rays = "150000";
    bool costs = false, json = false;
};

constexpr NumberInfo kCostRays{"rays", "R", "with --costs: rays of each run", 1000, 1'000'000'000, 150'000};

/// As given; else the scene's eye; else all its walls.
Sensor sensorAsked(const RequirementsTexts& texts, const SegmentIndex& index) {
    const Scene& scene = index.scene();
    Asked asked = scene.eye ? Asked::eye : Asked::profile;
    if (texts.at) asked = Asked::probe;
    if (!texts.render.walls.empty()) asked = Asked::profile;
    if (texts.sensor) asked = namedArgument("--sensor", *texts.sensor, kAsked);
    if (asked == Asked::probe) {
        if (!texts.at)
            throw InputError("--sensor probe: no place is given, expected --at X,Y or --at NAME:T");
        std::optional<Vec2> normal;
        if (texts.normal) normal = directionArgument("--normal", *texts.normal);
        return Probe{probePlace(index, *texts.at, normal).shaded};
    }
    RenderRequest request;
    request.sensor = static_cast<PictureSensor>(asked);
    request.texts = texts.render;
    if (request.texts.walls.empty()) request.texts.walls = "all";
    return pictureOf(request, scene).sensor;
}

int runRequirements(const RequirementsTexts& texts) {
    const std::vector<Forced> forced = forcedArguments(texts.force);
    const double tolerance = toleranceArgument(texts.tolerance);
    const std::uint64_t seed = wholeArgument("--seed", texts.render.seed, kSeedInfo);
    const Scene scene = expandScene(loadScene(texts.render.scene));
    const SegmentIndex index(scene);
    const Sensor sensor = sensorAsked(texts, index);
    const RequirementsQuestion question{index, sensor, tolerance, forced, seed};
    const CostLimits limits{.rays = wholeArgument("--rays", texts.rays, kCostRays)};
    RequirementsAnswer answer;
    const bool planned = askRequirements(question, answer);
    // The plan is of use while its costs are still being measured.
    if (!texts.json)
        writeOutput(fmt::format("{}, {}, tolerance {:g} %\n\n",
                                scene.title.empty() ? texts.render.scene : scene.title,
                                kSensorNames[sensor.index()], 100.0 * tolerance) +
                    requirementsText(answer, index));
    std::optional<Costs> costs;
    if (texts.costs && planned) costs = costsAsked(question, answer, limits);
    const bool stopped = !planned || (costs && !costs->complete());
    if (texts.json) {
        Json object{{"scene", texts.render.scene}, {"sensor", std::string(kSensorNames[sensor.index()])}};
        object.update(requirementsJson(answer, index));
        if (costs) object["costs"] = costsJson(*costs, index);
        writeJson(object);
    } else if (costs) {
        writeOutput(costsText(*costs));
    }
    if (stopped)
        writeError(planned ? fmt::format("stopped after {} of {} costs", costs->done, costs->pieces)
                           : "stopped before it was known what the scene requires: these are its facts");
    return stopped ? kExitStopped : kExitSuccess;
}

}  // namespace

void addRequirementsCommand(CLI::App& app, Action& chosen) {
    const auto texts = std::make_shared<RequirementsTexts>();
    CLI::App* command =
        app.add_subcommand("requirements", "tell what must be modelled in a scene, and what need not");
    command->add_option("SCENE", texts->render.scene, "scene file (TOML)")->required()->type_name("");
    command
        ->add_option("--sensor", texts->sensor,
                     "eye, profile, field or probe; without it, the scene's eye, or all walls")
        ->type_name("NAME");
    command
        ->add_option("--at", texts->at, "of a probe: a point in metres, or a wall's name and a place on it")
        ->type_name("X,Y|NAME:T");
    command->add_option("--normal", texts->normal, "of a probe that is on no wall")->type_name("X,Y");
    command->add_option("--walls", texts->render.walls, "of a profile; without it, all")
        ->type_name("NAME,...");
    command->add_option("--position", texts->render.position, "of an eye, in place of the scene's")
        ->type_name("X,Y");
    command->add_option("--direction", texts->render.direction, "of an eye, in place of the scene's")
        ->type_name("X,Y");
    command->add_option("--fov", texts->render.fov, "of an eye, degrees")->type_name("DEG");
    command->add_option("--min", texts->render.min, "of a field: lower left corner")->type_name("X,Y");
    command->add_option("--max", texts->render.max, "of a field: upper right corner")->type_name("X,Y");
    command
        ->add_option("--tolerance", texts->tolerance,
                     fmt::format("share of the light that may be missing or noise, {} to {}", kLeastTolerance,
                                 kMostTolerance))
        ->type_name("SHARE")
        ->capture_default_str();
    command->add_option("--force", texts->force, "a requirement as you want it; may be repeated")
        ->type_name("NAME=on|off|NUMBER")
        ->allow_extra_args(false);
    command->add_option("--seed", texts->render.seed, std::string(kSeedInfo.meaning))
        ->type_name("K")
        ->capture_default_str();
    command->add_flag("--costs", texts->costs,
                      "measure what skipping or adding each part costs in light, rays and time");
    command->add_option("--rays", texts->rays, std::string(kCostRays.meaning))
        ->type_name("R")
        ->capture_default_str();
    command->add_flag("--json", texts->json, "print one JSON object");
    command->footer(
        fmt::format("What the scene can't contain is left out by proof; between ways that carry all light, "
                    "short runs on the "
                    "scene decide, by rays, so that the plan is the same on every machine. `--estimator "
                    "auto` of probe, eye, "
                    "profile and field does what this plan says.\n\nWhat can be forced:\n{}\nExamples:\n"
                    "  halfdisk requirements room.toml\n"
                    "  halfdisk requirements room.toml --costs\n"
                    "  halfdisk requirements room.toml --sensor profile --walls floor --tolerance 0.001\n"
                    "  halfdisk requirements glass.toml --force light-pass=off --json",
                    describedSwitches()));
    command->callback([&chosen, texts] { chosen = [texts] { return runRequirements(*texts); }; });
}

}  // namespace halfdisk
