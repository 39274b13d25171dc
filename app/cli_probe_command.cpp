// halfdisk probe: how much light is at a point? The options, their help, and the order of the work.
#include <fmt/format.h>

#include <memory>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/cli_probe_passes.h"
#include "app/cli_probe_report.h"
#include "app/estimator_arguments.h"
#include "app/plan_words.h"
#include "app/requirements_json.h"
#include "app/requirements_text.h"
#include "lessons/scene_file.h"

namespace halfdisk {
namespace {

/// Takes the plan's estimator and settings if they are wanted, and tells the plan if that is.
std::optional<RequirementsAnswer> ask(const SegmentIndex& index, const ProbePlace& place,
                                      const ProbeTexts& texts, ProbeQuestion& question) {
    Sensor sensor = Probe{place.shaded};
    if (question.look) sensor = Look{place.shaded.P, *question.look};
    std::optional<RequirementsAnswer> required =
        requirementsAsked(question.plan, index, sensor, question.settings.seed);
    if (!required) return required;
    if (question.plan.automatic) {
        question.estimator = required->plan.estimator;
        question.params = required->plan.params;
        question.settings.maxDepth = required->plan.maxDepth;
        question.settings.maxSpecular = required->plan.maxSpecular;
    }
    if (question.plan.explain && !texts.json) writeOutput(explanation(*required, index, texts.estimator));
    return required;
}

int answerByPasses(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place,
                   const std::optional<RequirementsAnswer>& required, const ProbeTexts& texts) {
    PassesAnswer answer = probeByPasses(index, question, place);
    const Measurement& measurement = answer.measurement;
    if (measurement.film.passes == 0) {
        writeError("stopped before the first sample was done");
        return kExitStopped;
    }
    if (measurement.interrupted)
        writeError(fmt::format("stopped after {} of {} samples", measurement.film.passes, question.passes()));
    if (texts.json) {
        Json object = passesJson(answer);
        if (required) object["requirements"] = requirementsJson(*required, index);
        if (question.plan.automatic) tellLost(*required, object);
        writeJson(object);
    } else {
        if (!question.look) answer.exact = exactIrradiance(index.scene(), question.settings, place.shaded);
        writeOutput(passesTable(answer) + (question.plan.automatic ? lostWarning(*required) : std::string()));
    }
    return measurement.interrupted ? kExitStopped : kExitSuccess;
}

int answerByCastRay(const SegmentIndex& index, const ProbeQuestion& question, const ProbePlace& place,
                    const std::optional<RequirementsAnswer>& required, const ProbeTexts& texts) {
    ProbeAnswer answer = probe(index, question, place);
    if (texts.json) {
        Json object = probeJson(answer);
        if (required) object["requirements"] = requirementsJson(*required, index);
        writeJson(object);
    } else {
        answer.exact = exactIrradiance(index.scene(), question.settings, answer.place.shaded);
        writeOutput(probeTable(answer));
    }
    return kExitSuccess;
}

int runProbe(const ProbeTexts& texts) {
    ProbeQuestion question = probeQuestion(texts);
    const Scene scene = expandScene(loadScene(texts.scene));
    const SegmentIndex index(scene, question.plan.indexMethod());
    const ProbePlace place = question.look ? lookPlace(index, texts.at, *question.look)
                                           : probePlace(index, texts.at, question.normal);
    std::optional<RequirementsAnswer> required;
    if (question.plan.asks()) {
        required = ask(index, place, texts, question);
        if (!required) {
            writeError("stopped before it was known what the scene requires");
            return kExitStopped;
        }
    }
    return question.isByPasses() ? answerByPasses(index, question, place, required, texts)
                                 : answerByCastRay(index, question, place, required, texts);
}

std::string helpFooter() {
    return fmt::format(
        R"(A depth of D gives irradiance of light scattered at most D times before it arrives, and the radiance of a wall at D + 1. Mirrors and glass do not count.

cast-ray takes --samples rays from every wall that it meets, --repeat times; its options are --sampler, --emitters and --as-printed. All other estimators make --samples independent estimates, and their options are --param NAME=VALUE. The radiance of a wall is told where it is flat and matt: Le + albedo / 2 E.

Estimators (halfdisk estimators tells all of them):
{}
Samplers:
{}
Emitters, how light that leaves an emitting segment is counted:
{}
Defects, for --as-printed=LIST:
{}
Examples:
  halfdisk probe room.toml --at floor:0.25
  halfdisk probe room.toml --at 0.5,0.5 --normal 0,1 --samples 1e4 --sampler cosine
  halfdisk probe room.toml --at floor:0.25 --as-printed=frame,pdf --json
  halfdisk probe room.toml --at floor:0.25 --estimator path --samples 1e4 --param roulette=0
  halfdisk probe room.toml --at floor:0.25 --estimator auto --samples 1e4 --explain
  halfdisk probe room.toml --at 1,1 --look 1,0 --estimator path --samples 100 --list --json)",
        describedEstimators(), describedNames(kSamplers), describedNames(kEmitters),
        describedNames(kDefects));
}

template <class Table>
void addChoice(CLI::App& command, const std::string& option, std::string_view meaning, const Table& table,
               std::string_view initial, std::optional<std::string>& text) {
    command.add_option(option, text, fmt::format("{}: {} [{}]", meaning, joinedNames(table), initial))
        ->type_name("NAME");
}

}  // namespace

void addProbeCommand(CLI::App& app, Action& chosen) {
    const auto texts = std::make_shared<ProbeTexts>();
    CLI::App* command = app.add_subcommand("probe", "measure the light at a point of a scene");
    command->add_option("SCENE", texts->scene, "scene file (TOML)")->required()->type_name("");
    command
        ->add_option("--at", texts->at, "a point in metres, or a wall's name and a place on it from 0 to 1")
        ->type_name("X,Y|NAME:T")
        ->required();
    command
        ->add_option(
            "--normal", texts->normal,
            "middle of the half-disk; without it, the front of the wall at the point, and its radiance too")
        ->type_name("X,Y");
    command->add_option("--look", texts->look, "radiance that arrives from there, in place of irradiance")
        ->type_name("X,Y");
    command->add_option("--estimator", texts->estimator, "how light is carried")
        ->type_name("NAME")
        ->capture_default_str();
    command->add_option("--param", texts->params, "a parameter of the estimator; may be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    addNumber(*command, kProbeSamplesInfo, "N", texts->samples);
    addNumber(*command, kMaxDepthInfo, "D", texts->depth);
    addNumber(*command, kMaxSpecularInfo, "S", texts->specular);
    addChoice(*command, "--sampler", "how directions are drawn", kSamplers,
              nameOf(kSamplers, Settings{}.sampler), texts->sampler);
    addChoice(*command, "--emitters", "how emitting segments are found", kEmitters,
              nameOf(kEmitters, Settings{}.emitters), texts->emitters);
    // A flag: without `=` it takes no value, so that what follows stays an argument of its own.
    command
        ->add_flag("--as-printed", texts->asPrinted,
                   "run the published listing's defects: all, or those listed")
        ->type_name("[=LIST]");
    addNumber(*command, kSeedInfo, "K", texts->seed);
    command
        ->add_option("--repeat", texts->repeats,
                     fmt::format("{} [{}]", kRepeatsInfo.meaning, kRepeatsInfo.initial))
        ->type_name("R");
    command->add_option("--threads", texts->threads, std::string(kThreadsInfo.meaning))->type_name("T");
    addPlanOptions(*command, texts->plan);
    command->add_flag("--anyway", texts->anyway, "cast the rays even if they are more than 10^10");
    command->add_flag("--json", texts->json, "print one JSON object");
    command->add_flag("--list", texts->list,
                      fmt::format("with --json: the values of all samples (of cast-ray: repeats), {} at most",
                                  kMostListed));
    command->footer(helpFooter());
    command->callback([&chosen, texts, command] {
        texts->plan.depthGiven = command->count("--depth") > 0;
        texts->plan.specularGiven = command->count("--specular") > 0;
        chosen = [texts] { return runProbe(*texts); };
    });
}

}  // namespace halfdisk
