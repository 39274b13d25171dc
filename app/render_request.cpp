// What is asked by `halfdisk eye`, `profile` and `field`? As typed, and checked as far as the scene is not
// needed.
#include "app/render_request.h"

#include <fmt/format.h>

#include "app/cli_arguments.h"
#include "app/render_output.h"

namespace halfdisk {
namespace {

double secondsArgument(std::string_view text) {
    const std::optional<double> seconds = parseNumber(text);
    if (!seconds || *seconds <= 0.0 || *seconds > kMostSeconds)
        failArgument("--seconds", text,
                     fmt::format("is not a number of seconds above 0, at most {}", kMostSeconds));
    return *seconds;
}

MeasureLimits limitsOf(const RenderTexts& texts) {
    if (texts.samples && texts.seconds)
        throw InputError("--samples and --seconds exclude each other, expected one of them");
    MeasureLimits limits;
    limits.passes = kPassesInfo.initial;
    if (texts.samples) limits.passes = wholeArgument("--samples", *texts.samples, kPassesInfo);
    if (texts.seconds) {
        limits.seconds = secondsArgument(*texts.seconds);
        limits.passes = kPassesInfo.most;
    }
    limits.threads = threadsArgument(texts.threads);
    return limits;
}

/// As it is, or in single quotes where a shell would read more into it.
std::string quoted(const std::string& text) {
    constexpr std::string_view kPlain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=,.:/@%";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
    std::string inQuotes = "'";
    for (const char c : text) {
        if (c == '\'') inQuotes += "'\\'";
        inQuotes += c;
    }
    inQuotes += '\'';
    return inQuotes;
}

std::string quoted(std::uint64_t number) {
    return std::to_string(number);
}

}  // namespace

RenderRequest renderRequest(PictureSensor sensor, const RenderTexts& texts) {
    RenderRequest request;
    request.sensor = sensor;
    request.texts = texts;
    request.maxDepth = static_cast<std::uint32_t>(wholeArgument("--depth", texts.depth, kMaxDepthInfo));
    request.maxSpecular =
        static_cast<std::uint32_t>(wholeArgument("--specular", texts.specular, kMaxSpecularInfo));
    request.plan =
        planRequest(texts.plan, texts.estimator, texts.params, request.maxDepth, request.maxSpecular);
    if (!request.plan.automatic) {
        request.estimator = &estimatorArgument(texts.estimator);
        request.params = paramArguments(*request.estimator, texts.params);
    }
    request.seed = wholeArgument("--seed", texts.seed, kSeedInfo);
    request.limits = limitsOf(texts);
    if (texts.exposure)
        request.exposure = numberArgument("--exposure", *texts.exposure, -kMostExposure, kMostExposure);
    for (const std::string& output : texts.outputs) request.outputs.emplace_back(output);
    refuseOutputs(request.outputs);
    return request;
}

void refuseTooManySamples(const RenderRequest& request, std::uint32_t pixels) {
    const double samples = static_cast<double>(request.limits.passes) * pixels;
    if (request.texts.anyway || request.limits.seconds || samples <= kMostPixelSamples) return;
    throw InputError(
        fmt::format("these are {:.3g} samples of pixels, more than 10^11: lower --samples or --width, give "
                    "--seconds, or add --anyway",
                    samples));
}

std::string commandFor(const RenderRequest& request, std::uint64_t samples, std::uint32_t width,
                       std::uint32_t height) {
    const RenderTexts& texts = request.texts;
    std::string command = fmt::format("{} {}", nameOf(kPictureSensors, request.sensor), quoted(texts.scene));
    const auto add = [&](std::string_view option, const auto& value) {
        command += fmt::format(" {} {}", option, quoted(value));
    };
    const auto addGiven = [&](std::string_view option, const std::optional<std::string>& value) {
        if (value) add(option, *value);
    };
    addGiven("--position", texts.position);
    addGiven("--direction", texts.direction);
    addGiven("--fov", texts.fov);
    if (request.sensor == PictureSensor::profile) add("--walls", texts.walls);
    addGiven("--min", texts.min);
    addGiven("--max", texts.max);
    add("--estimator", std::string(request.estimator->id));
    add("--samples", samples);
    for (std::size_t i = 0; i < request.params.size(); ++i) {
        const ParamInfo& param = request.estimator->params[i];
        add("--param", fmt::format("{}={}", param.name, paramText(param, request.params[i])));
    }
    add("--depth", std::uint64_t{request.maxDepth});
    add("--specular", std::uint64_t{request.maxSpecular});
    add("--seed", request.seed);
    add("--width", std::uint64_t{width});
    add("--height", std::uint64_t{height});
    addGiven("--exposure", texts.exposure);
    if (static_cast<double>(samples) * width * height > kMostPixelSamples) command += " --anyway";
    return command;
}

}  // namespace halfdisk
