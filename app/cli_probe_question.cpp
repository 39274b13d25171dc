// What do the options of a probe mean together? castRay has options of its own; all others have parameters.
#include <fmt/format.h>

#include "app/cli_arguments.h"
#include "app/cli_probe.h"
#include "app/estimator_arguments.h"

namespace halfdisk {
namespace {

Settings commonSettings(const ProbeTexts& texts) {
    Settings settings;
    settings.samples =
        static_cast<std::uint32_t>(wholeArgument("--samples", texts.samples, kProbeSamplesInfo));
    settings.maxDepth = static_cast<std::uint32_t>(wholeArgument("--depth", texts.depth, kMaxDepthInfo));
    settings.maxSpecular =
        static_cast<std::uint32_t>(wholeArgument("--specular", texts.specular, kMaxSpecularInfo));
    settings.seed = wholeArgument("--seed", texts.seed, kSeedInfo);
    return settings;
}

void readCastRayOptions(const ProbeTexts& texts, ProbeQuestion& question) {
    if (!texts.params.empty())
        failArgument("--param", texts.params.front(),
                     "is not for cast-ray, whose options are --samples, --sampler, --emitters and --repeat");
    Settings& settings = question.settings;
    if (texts.sampler) settings.sampler = namedArgument("--sampler", *texts.sampler, kSamplers);
    if (texts.emitters) settings.emitters = namedArgument("--emitters", *texts.emitters, kEmitters);
    if (texts.asPrinted == "true") {
        settings.defects = DefectSet::all();
    } else if (!texts.asPrinted.empty()) {
        settings.defects = defectsArgument("--as-printed", texts.asPrinted);
    }
    if (texts.repeats) question.repeats = wholeArgument("--repeat", *texts.repeats, kRepeatsInfo);
    if (!question.look) return;
    if (settings.defects != DefectSet{})
        throw InputError("--as-printed: the published listing has no way to look along one ray");
    question.params = paramArguments(*question.estimator,
                                     {fmt::format("samples={}", settings.samples),
                                      fmt::format("sampler={}", nameOf(kSamplers, settings.sampler)),
                                      fmt::format("emitters={}", nameOf(kEmitters, settings.emitters))});
}

void refuseCastRayOptions(const ProbeTexts& texts, const EstimatorInfo& info) {
    const auto refuse = [&](std::string_view option, std::string_view instead) {
        throw InputError(fmt::format("{} is for cast-ray only; {} has {}", option, info.id, instead));
    };
    if (texts.sampler) refuse("--sampler", "--param");
    if (texts.emitters) refuse("--emitters", "--param");
    if (texts.repeats) refuse("--repeat", "independent --samples");
    if (!texts.asPrinted.empty()) refuse("--as-printed", "no printed defects");
}

}  // namespace

ProbeQuestion probeQuestion(const ProbeTexts& texts) {
    ProbeQuestion question;
    question.settings = commonSettings(texts);
    question.plan = planRequest(texts.plan, texts.estimator, texts.params, question.settings.maxDepth,
                                question.settings.maxSpecular);
    question.estimator =
        question.plan.automatic ? findEstimator(kDefaultEstimator) : &estimatorArgument(texts.estimator);
    if (texts.normal) question.normal = directionArgument("--normal", *texts.normal);
    if (texts.look) question.look = directionArgument("--look", *texts.look);
    if (texts.normal && texts.look)
        throw InputError("--normal and --look exclude each other: irradiance has a normal, radiance a ray");
    if (question.isCastRay()) {
        readCastRayOptions(texts, question);
    } else {
        refuseCastRayOptions(texts, *question.estimator);
        question.params = paramArguments(*question.estimator, texts.params);
    }
    question.threads = threadsArgument(texts.threads);
    question.anyway = texts.anyway;
    question.list = texts.list;
    if (texts.list && !texts.json)
        throw InputError("--list: values are a part of the JSON object, add --json");
    if (texts.list && question.passes() > kMostListed)
        throw InputError(fmt::format("--list: {} values are too many, expected at most {}", question.passes(),
                                     kMostListed));
    return question;
}

}  // namespace halfdisk
