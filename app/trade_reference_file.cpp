#include "app/trade_reference_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/pfm_image.h"
#include "core/estimators.h"
#include "lessons/input_error.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file) {
    if (fs::is_directory(file)) throw InputError(file.string(), "this is a directory, expected a file");
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(stream), {});
    if (!stream)
        throw InputError(file.string(), "cannot be read, expected what halfdisk eye, profile or field wrote");
    return bytes;
}

std::vector<Rgb> pixelsFrom(const Json& json) {
    std::vector<Rgb> pixels;
    for (const Json& pixel : json)
        pixels.push_back({pixel.at(0).get<double>(), pixel.at(1).get<double>(), pixel.at(2).get<double>()});
    return pixels;
}

TradeReference fromPfm(const fs::path& file, bool strip) {
    TradeReference reference;
    try {
        const LinearImage image = decodePfm(bytesOf(file));
        reference.mean = image.pixels;
        if (strip && reference.mean.size() > image.width) reference.mean.resize(image.width);
    } catch (const InputError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw InputError(file.string(), error.what());
    }
    reference.how = fmt::format("from {}, which tells no error and is taken for exact", file.string());
    return reference;
}

/// Throws InputError if the picture is of another scene, or of another part of its light.
void checkFacts(const fs::path& file, const Json& picture, const Json& asked) {
    for (const auto& fact : asked.items()) {
        if (!picture.contains(fact.key()) || picture[fact.key()] == fact.value()) continue;
        if (fact.key() == "sceneHash")
            throw InputError(file.string(), "is a picture of another scene, expected one of this scene");
        throw InputError(file.string(), fmt::format("is a picture with {} = {}, expected {}", fact.key(),
                                                    picture[fact.key()].dump(), fact.value().dump()));
    }
}

TradeReference fromJson(const fs::path& file, const Json& asked) {
    TradeReference reference;
    reference.how = fmt::format("from {}", file.string());
    try {
        const Json json = Json::parse(bytesOf(file));
        const Json& errors = json.at("standardError");
        reference.mean = pixelsFrom(json.at("mean"));
        if (!errors.is_array() || errors.size() != reference.mean.size() ||
            std::any_of(errors.begin(), errors.end(), [](const Json& error) { return error.is_null(); }))
            throw InputError(file.string(),
                             "has pixels without standard error, expected two samples or more");
        reference.standardError = pixelsFrom(errors);
        checkFacts(file, json, asked);
        const EstimatorInfo* estimator = findEstimator(json.at("estimator").get<std::string>());
        if (estimator && !estimator->bias.empty())
            reference.how +=
                fmt::format("; it is by {}, which has a bias that no error tells", estimator->id);
        if (const auto cut = json.value("cut", std::uint64_t{0}); cut > 0)
            reference.how += fmt::format(
                "; {} of {} paths were given up after {} mirror and glass events: their light is missing",
                cut, json.at("paths").get<std::uint64_t>(), json.at("specular").get<std::uint64_t>());
    } catch (const Json::exception&) {
        throw InputError(file.string(),
                         "is not what halfdisk eye, profile or field wrote, expected such a .json or a .pfm");
    }
    return reference;
}

}  // namespace

TradeReference referenceFromFile(const fs::path& file, const AskedPicture& asked) {
    TradeReference reference =
        file.extension() == ".pfm" ? fromPfm(file, asked.strip) : fromJson(file, asked.facts);
    const std::size_t pixels = reference.mean.size();
    if (pixels != asked.pixels)
        throw InputError(
            file.string(),
            fmt::format("has {} pixels, expected {} as is asked (--width, --height)", pixels, asked.pixels));
    double squares = 0.0;
    for (const Rgb& pixel : reference.mean) {
        if (!isFinite(pixel)) throw InputError(file.string(), "has a pixel that is no number");
        if (std::min({pixel.x, pixel.y, pixel.z}) < 0.0)
            throw InputError(file.string(), "has a pixel below zero, expected light");
    }
    for (const Rgb& error : reference.standardError)
        squares += glm::dot(error, error) / (3.0 * static_cast<double>(pixels));
    const double light = reference.light();
    if (light > 0.0) reference.relativeError = std::sqrt(squares) / light;
    return reference;
}

}  // namespace halfdisk
