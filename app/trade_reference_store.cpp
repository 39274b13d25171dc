#include "app/trade_reference_store.h"

#include <algorithm>

#include "app/trade_json.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

fs::path wholeFile(const fs::path& folder) {
    return folder / "reference.json";
}
fs::path begunFile(const fs::path& folder) {
    return folder / "reference.begun.json";
}

Json picturesJson(const std::vector<Picture>& pictures) {
    Json json = Json::array();
    for (const Picture& picture : pictures) json.push_back(pictureJson(picture));
    return json;
}
std::vector<Picture> picturesFrom(const Json& json) {
    std::vector<Picture> pictures;
    for (const Json& picture : json) pictures.push_back(pictureFrom(picture));
    return pictures;
}

void requireSizes(const fs::path& file, const std::vector<Picture>& pictures, std::size_t size) {
    for (const Picture& picture : pictures)
        if (picture.size() != size) failDamaged(file);
}

/// `pixels` 0: not known.
void requireConsistent(const fs::path& file, const TradeReference& reference, std::uint32_t pixels) {
    const std::size_t size = reference.mean.size();
    const bool some = !reference.pixels.empty();
    const bool inside = std::all_of(reference.pixels.begin(), reference.pixels.end(),
                                    [&](std::uint32_t pixel) { return pixels == 0 || pixel < pixels; });
    const bool fits = some ? reference.pixels.size() == size : pixels == 0 || size == pixels;
    if (size == 0 || !inside || !fits) failDamaged(file);
    requireSizes(file, reference.groups, size);
    if (!reference.standardError.empty()) requireSizes(file, {reference.standardError}, size);
}

}  // namespace

std::optional<TradeReference> readReference(const fs::path& folder, const Json& question,
                                            std::uint32_t pixels) {
    const fs::path file = wholeFile(folder);
    std::error_code failed;
    if (!fs::exists(file, failed)) return std::nullopt;
    return readTradeFile(file, [&](const Json& json) {
        requireQuestion(file, json.at("question"), question);
        TradeReference reference;
        reference.how = json.at("how").get<std::string>();
        reference.relativeError = json.at("relativeError").get<double>();
        reference.pixels = json.at("pixels").get<std::vector<std::uint32_t>>();
        reference.mean = pictureFrom(json.at("mean"));
        reference.standardError = pictureFrom(json.at("standardError"));
        reference.groups = picturesFrom(json.at("groups"));
        requireConsistent(file, reference, pixels);
        return reference;
    });
}

void writeReference(const fs::path& folder, const Json& question, const TradeReference& reference) {
    Json json;
    json["question"] = question;
    json["how"] = reference.how;
    json["relativeError"] = reference.relativeError;
    json["pixels"] = reference.pixels;
    json["mean"] = pictureJson(reference.mean);
    json["standardError"] = pictureJson(reference.standardError);
    json["groups"] = picturesJson(reference.groups);
    writeTradeFile(wholeFile(folder), std::move(json));
    std::error_code failed;
    fs::remove(begunFile(folder), failed);
}

BegunRun readBegunReference(const fs::path& folder, const Json& question, std::uint32_t pixels) {
    const fs::path file = begunFile(folder);
    std::error_code failed;
    if (!fs::exists(file, failed)) return {};
    return readTradeFile(file, [&](const Json& json) {
        requireQuestion(file, json.at("question"), question);
        BegunRun begun;
        begun.estimator = json.at("estimator").get<std::string>();
        GroupedPasses& run = begun.run;
        run.groups.each = json.at("each").get<std::uint64_t>();
        run.groups.means = picturesFrom(json.at("groups"));
        run.seconds = json.at("seconds").get<double>();
        run.counts.rays = json.at("rays").get<std::uint64_t>();
        run.counts.paths = json.at("paths").get<std::uint64_t>();
        run.counts.cut = json.at("cut").get<std::uint64_t>();
        run.counts.nonFinite = json.at("nonFinite").get<std::uint64_t>();
        requireSizes(file, run.groups.means, pixels);
        if (run.groups.passes() == 0 || run.groups.means.size() >= PassGroups::kMost ||
            run.groups.passes() != json.at("passes").get<std::uint64_t>())
            failDamaged(file);
        return begun;
    });
}

void writeBegunReference(const fs::path& folder, const Json& question, const BegunRun& begun) {
    const GroupedPasses& run = begun.run;
    Json json;
    json["question"] = question;
    json["estimator"] = begun.estimator;
    json["each"] = run.groups.each;
    json["passes"] = run.groups.passes();
    json["seconds"] = run.seconds;
    json["rays"] = run.counts.rays;
    json["paths"] = run.counts.paths;
    json["cut"] = run.counts.cut;
    json["nonFinite"] = run.counts.nonFinite;
    json["groups"] = picturesJson(run.groups.means);
    writeTradeFile(begunFile(folder), std::move(json));
}

std::vector<std::string> copyReference(const std::vector<fs::path>& folders, const fs::path& to,
                                       const Json& question) {
    std::vector<std::string> problems;
    bool copied = false;
    for (const fs::path& folder : folders) {
        try {
            const std::optional<TradeReference> reference = readReference(folder, question, 0);
            if (reference && !copied) writeReference(to, question, *reference);
            copied = copied || reference;
        } catch (const InputError& error) {
            problems.emplace_back(error.what());
        }
    }
    return problems;
}

}  // namespace halfdisk
