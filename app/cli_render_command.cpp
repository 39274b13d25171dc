// halfdisk eye, halfdisk profile, halfdisk field: what does the light look like? The options, their help, and
// the order of the work.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/plan_words.h"
#include "app/render_output.h"
#include "app/render_report.h"
#include "app/requirements_json.h"
#include "app/requirements_text.h"
#include "app/scene_hash.h"
#include "app/tone.h"
#include "lessons/scene_file.h"

namespace halfdisk {
namespace {

void take(const Plan& plan, RenderRequest& request) {
    request.estimator = plan.estimator;
    request.params = plan.params;
    request.maxDepth = plan.maxDepth;
    request.maxSpecular = plan.maxSpecular;
}

int runRender(PictureSensor sensor, const RenderTexts& texts) {
    RenderRequest request = renderRequest(sensor, texts);
    const SceneDescription description = loadScene(texts.scene);
    request.sceneHash = sceneHash(description);
    const Scene scene = expandScene(description);
    const SegmentIndex index(scene, request.plan.indexMethod());
    const PictureOf picture = pictureOf(request, scene);
    refuseTooManySamples(request, pixelCount(picture.sensor));

    std::optional<RequirementsAnswer> required;
    if (request.plan.asks()) {
        required = requirementsAsked(request.plan, index, picture.sensor, request.seed);
        if (!required) {
            writeError("stopped before it was known what the scene requires; nothing is written");
            return kExitStopped;
        }
    }
    if (request.plan.automatic) take(required->plan, request);
    if (request.plan.explain && !texts.json) writeOutput(explanation(*required, index, texts.estimator));

    const Problem problem{index, picture.sensor, request.maxDepth, request.maxSpecular, request.seed};
    RenderResult result{request, index, picture,
                        measure(*request.estimator, problem, request.params, request.limits)};
    const Measurement& measurement = result.measurement;
    if (measurement.film.passes == 0) {
        writeError("stopped before the first sample was done; nothing is written");
        return kExitStopped;
    }
    result.scale =
        request.exposure ? std::exp2(*request.exposure) : automaticScale(meansOf(measurement.film));
    writeOutputs(request.outputs, result);
    if (measurement.interrupted)
        writeError(fmt::format("stopped after {}; written", howFar(measurement, request.limits)));
    if (texts.json) {
        Json object = renderJson(result);
        if (required) object["requirements"] = requirementsJson(*required, index);
        if (request.plan.automatic) tellLost(*required, object);
        writeJson(object);
    } else {
        writeOutput(renderTable(result) + (request.plan.automatic ? lostWarning(*required) : std::string()));
    }
    return measurement.interrupted ? kExitStopped : kExitSuccess;
}

void addSensorOptions(CLI::App& command, PictureSensor sensor, RenderTexts& texts) {
    switch (sensor) {
        case PictureSensor::eye:
            command.add_option("--position", texts.position, "in place of the scene's eye's, metres")
                ->type_name("X,Y");
            command.add_option("--direction", texts.direction, "in place of the scene's eye's")
                ->type_name("X,Y");
            command.add_option("--fov", texts.fov, "whole field of view, degrees")->type_name("DEG");
            break;
        case PictureSensor::profile:
            command
                .add_option("--walls", texts.walls,
                            "fronts of walls, one after the other: floor, box (all its walls), box.2, all")
                ->type_name("NAME,...")
                ->required();
            break;
        case PictureSensor::field:
            command.add_option("--min", texts.min, "lower left corner; without it, around the scene")
                ->type_name("X,Y");
            command.add_option("--max", texts.max, "upper right corner")->type_name("X,Y");
            break;
    }
}

struct SizeHelp {
    const char* width;
    const char* height;
};

SizeHelp sizeHelp(PictureSensor sensor) {
    switch (sensor) {
        case PictureSensor::eye:
            return {"pixels of the strip [512]", "how often the strip is repeated in a picture [64]"};
        case PictureSensor::profile:
            return {"bins, of equal length [64]", "how often the bins are repeated in a picture [64]"};
        case PictureSensor::field:
            break;
    }
    return {"cells across [256]", "cells up; without it, cells are squares"};
}

std::string examplesOf(PictureSensor sensor) {
    switch (sensor) {
        case PictureSensor::eye:
            return "  halfdisk eye room.toml -o room.png\n"
                   "  halfdisk eye room.toml --position 1,1 --direction 1,0 --fov 90 --depth 4 --seconds 10 "
                   "-o room.png -o room.json\n"
                   "  halfdisk eye room.toml --estimator auto --explain -o room.png";
        case PictureSensor::profile:
            return "  halfdisk profile glass.toml --walls floor --estimator light --samples 1e4 -o "
                   "caustic.csv\n"
                   "  halfdisk profile room.toml --walls floor,ceiling,block --width 256 -o walls.png";
        case PictureSensor::field:
            break;
    }
    return "  halfdisk field room.toml --estimator light --param roulette=0 --seconds 10 -o room.png\n"
           "  halfdisk field room.toml --min 0,0 --max 2,1 --width 512 -o corner.pfm";
}

std::string footerOf(PictureSensor sensor) {
    std::string formats;
    for (const OutputFormat& format : kOutputFormats)
        formats += fmt::format("  {:<6} {}\n", format.extension, format.meaning);
    return fmt::format(
        "A depth of D gives irradiance and fluence of light scattered at most D times, and radiance of D + "
        "1; "
        "mirrors and glass do not count.\nThe result depends on the seed, not on the threads. Ctrl-C ends "
        "the work at once and writes the samples that are done (exit code 130).\n\nEstimators (halfdisk "
        "estimators tells all of them):\n{}\nFiles:\n{}\nExamples:\n{}",
        describedEstimators(), formats, examplesOf(sensor));
}

void addRender(CLI::App& app, Action& chosen, PictureSensor sensor) {
    const auto texts = std::make_shared<RenderTexts>();
    CLI::App* command =
        app.add_subcommand(std::string(nameOf(kPictureSensors, sensor)),
                           std::string(kPictureSensors[static_cast<std::size_t>(sensor)].meaning));
    command->add_option("SCENE", texts->scene, "scene file (TOML)")->required()->type_name("");
    addSensorOptions(*command, sensor, *texts);
    command->add_option("--estimator", texts->estimator, "how light is carried")
        ->type_name("NAME")
        ->capture_default_str();
    command->add_option("--param", texts->params, "a parameter of the estimator; may be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    command
        ->add_option("--samples", texts->samples,
                     fmt::format("{} [{}]", kPassesInfo.meaning, kPassesInfo.initial))
        ->type_name("N");
    command->add_option("--seconds", texts->seconds, "in place of --samples: as many as this time allows")
        ->type_name("T");
    addNumber(*command, kMaxDepthInfo, "D", texts->depth);
    addNumber(*command, kMaxSpecularInfo, "S", texts->specular);
    addNumber(*command, kSeedInfo, "K", texts->seed);
    command->add_option("--threads", texts->threads, std::string(kThreadsInfo.meaning))->type_name("T");
    command->add_option("--width", texts->width, sizeHelp(sensor).width)->type_name("W");
    command->add_option("--height", texts->height, sizeHelp(sensor).height)->type_name("H");
    command
        ->add_option("--exposure", texts->exposure,
                     "of a PNG: light times 2^EV; without it, the brightest hundredth is white")
        ->type_name("EV");
    command->add_option("-o,--output", texts->outputs, "a file to write; may be repeated")
        ->type_name("FILE.(png|pfm|csv|json)")
        ->allow_extra_args(false)
        ->required();
    addPlanOptions(*command, texts->plan);
    command->add_flag("--anyway", texts->anyway, "work even if samples times pixels are more than 10^11");
    command->add_flag("--json", texts->json, "print the summary as one JSON object");
    command->footer(footerOf(sensor));
    command->callback([&chosen, texts, sensor, command] {
        texts->plan.depthGiven = command->count("--depth") > 0;
        texts->plan.specularGiven = command->count("--specular") > 0;
        chosen = [texts, sensor] { return runRender(sensor, *texts); };
    });
}

}  // namespace

void addRenderCommands(CLI::App& app, Action& chosen) {
    for (const auto& sensor : kPictureSensors) addRender(app, chosen, sensor.value);
}

}  // namespace halfdisk
