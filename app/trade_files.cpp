// How does a folder keep what was measured, cell by cell, so that work can be shared, stopped and gone on
// with?
#include "app/trade_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "app/estimator_arguments.h"
#include "lessons/atomic_file.h"
#include "lessons/input_error.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

Json uncertainJson(const Uncertain& number) {
    return Json::array({jsonOf(number.value), jsonOf(number.error)});
}
double numberFrom(const Json& json) {
    return json.is_null() ? std::nan("") : json.get<double>();
}
Uncertain uncertainFrom(const Json& json) {
    return {numberFrom(json.at(0)), numberFrom(json.at(1))};
}
Json pictureJson(const Picture& picture) {
    Json pixels = Json::array();
    for (const Rgb& pixel : picture) pixels.push_back(jsonOf(pixel));
    return pixels;
}
Picture pictureFrom(const Json& json) {
    Picture picture;
    for (const Json& pixel : json)
        picture.push_back({numberFrom(pixel.at(0)), numberFrom(pixel.at(1)), numberFrom(pixel.at(2))});
    return picture;
}

/// Throws InputError with the file's name if it is no JSON, or lacks what `read` asks for.
template <class Read>
auto readJson(const fs::path& file, const Read& read) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    if (!stream) throw InputError(file.string(), "cannot be read");
    try {
        return read(Json::parse(bytes));
    } catch (const Json::exception&) {
        throw InputError(file.string(), "is damaged, or not what halfdisk trade wrote");
    }
}

/// What the first differing key is, in words.
std::string differenceOf(const Json& here, const Json& asked) {
    for (const auto& item : asked.items())
        if (!here.contains(item.key()) || here[item.key()] != item.value()) {
            if (item.key() == "settings") return "it compares other settings (--estimators, --sweep)";
            return fmt::format("its {} is {}, not {}", item.key(),
                               here.contains(item.key()) ? here[item.key()].dump() : "unknown",
                               item.value().dump());
        }
    return "it is about something else";
}

std::string shortened(std::string text) {
    constexpr std::size_t kMost = 200;
    if (text.size() > kMost) text = text.substr(0, kMost) + " ...";
    return text;
}

TradeCell cellFrom(const fs::path& file, const Json& json) {
    const auto refuse = [&](const std::string& why) { throw InputError(file.string(), why); };
    TradeCell cell;
    TradeSetting& setting = cell.setting;
    setting.estimator = findEstimator(json.at("estimator").get<std::string>());
    if (setting.estimator == nullptr)
        refuse(fmt::format("the estimator {} is unknown", json.at("estimator").dump()));
    setting.params = json.at("params").get<std::vector<double>>();
    if (setting.params.size() != setting.estimator->params.size())
        refuse("the parameters are not those of the estimator");
    setting.maxDepth = json.at("depth").get<std::uint32_t>();
    setting.facets = json.at("facets").get<double>();
    const auto index = json.at("index").get<unsigned>();
    if (index >= kIndexMethods.size()) refuse(fmt::format("the index {} is unknown", index));
    setting.index = static_cast<IndexMethod>(index);  // with it the precision
    cell.name = json.at("name").get<std::string>();
    cell.complete = json.at("complete").get<bool>();
    cell.refusal = json.at("refusal").get<std::string>();
    if (!cell.measured()) return cell;
    cell.passes = json.at("passes").get<std::uint64_t>();
    cell.groups = json.at("groups").get<std::uint64_t>();
    cell.rays = json.at("rays").get<std::uint64_t>();
    cell.cut = json.at("cut").get<std::uint64_t>();
    cell.nonFinite = json.at("nonFinite").get<std::uint64_t>();
    cell.preparationSeconds = json.at("preparationSeconds").get<double>();
    cell.seconds = json.at("seconds").get<double>();
    cell.statistics.variance = uncertainFrom(json.at("variance"));
    cell.statistics.bias2 = uncertainFrom(json.at("bias2"));
    cell.statistics.noise = numberFrom(json.at("noise"));
    cell.statistics.mse = uncertainFrom(json.at("groupMse"));
    cell.statistics.mean = numberFrom(json.at("mean"));
    for (const Json& level : json.at("levels"))
        cell.levels.push_back(
            {level.at(0).get<double>(), {numberFrom(level.at(1)), numberFrom(level.at(2))}});
    if (!json.at("exponent").is_null()) cell.exponent = uncertainFrom(json.at("exponent"));
    return cell;
}

struct CellFile {
    Json question;
    TradeTruth truth;
    std::string referenceWords;
    double target = 0.05;
    std::size_t number = 0;
    TradeCell cell;
};

CellFile readCellFile(const fs::path& file) {
    return readJson(file, [&](const Json& json) {
        const Json& truth = json.at("truth");
        return CellFile{json.at("question"),
                        {truth.at("light").get<double>(), truth.at("relativeError").get<double>(),
                         truth.at("exact").get<bool>(), json.at("question").at("depth").get<std::uint32_t>()},
                        truth.at("reference").get<std::string>(),
                        json.at("target").get<double>(),
                        json.at("number").get<std::size_t>(),
                        cellFrom(file, json.at("cell"))};
    });
}

/// Sorted, so that what is read first does not depend on the disk.
std::vector<fs::path> cellFiles(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder / "cells", failed))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

Json cellJson(const TradeCell& cell) {
    Json json;
    json["name"] = cell.name;
    json["estimator"] = std::string(cell.setting.estimator->id);
    json["params"] = cell.setting.params;
    json["depth"] = cell.setting.maxDepth;
    json["facets"] = cell.setting.facets;
    json["index"] = static_cast<unsigned>(cell.setting.index);
    json["precision"] = std::string(nameOf(kPrecisions, precisionOf(cell.setting.index)));
    json["complete"] = cell.complete;
    json["refusal"] = cell.refusal;
    if (!cell.measured()) return json;
    json["passes"] = cell.passes;
    json["groups"] = cell.groups;
    json["rays"] = cell.rays;
    json["cut"] = cell.cut;
    json["nonFinite"] = cell.nonFinite;
    json["preparationSeconds"] = cell.preparationSeconds;
    json["seconds"] = cell.seconds;
    json["variance"] = uncertainJson(cell.statistics.variance);
    json["bias2"] = uncertainJson(cell.statistics.bias2);
    json["noise"] = jsonOf(cell.statistics.noise);
    json["groupMse"] = uncertainJson(cell.statistics.mse);
    json["mean"] = jsonOf(cell.statistics.mean);
    json["levels"] = Json::array();
    for (const TradeLevel& level : cell.levels)
        json["levels"].push_back({level.passes, jsonOf(level.mse.value), jsonOf(level.mse.error)});
    json["exponent"] = cell.exponent ? uncertainJson(*cell.exponent) : Json(nullptr);
    return json;
}

std::map<std::size_t, TradeCell> readCells(const fs::path& folder, const Json& question) {
    std::map<std::size_t, TradeCell> cells;
    for (const fs::path& file : cellFiles(folder)) {
        CellFile read = readCellFile(file);
        if (read.question != question)
            throw InputError(
                file.string(),
                fmt::format("answers another question: {}; expected an empty folder, or the same question",
                            shortened(differenceOf(read.question, question))));
        cells.emplace(read.number, std::move(read.cell));
    }
    return cells;
}

void writeCell(const fs::path& folder, const TradeFolder& trade, std::size_t number) {
    Json json;
    json["question"] = trade.question;
    json["target"] = trade.target;
    json["truth"] = {{"light", trade.truth.light},
                     {"relativeError", trade.truth.relativeError},
                     {"exact", trade.truth.exact},
                     {"reference", trade.referenceWords}};
    json["number"] = number;
    json["cell"] = cellJson(trade.cells.at(number));
    writeFileAtomically(folder / "cells" / fmt::format("{:04}.json", number), json.dump(1) + '\n');
}

std::optional<TradeReference> readReference(const fs::path& folder, const Json& question) {
    const fs::path file = folder / "reference.json";
    std::error_code failed;
    if (!fs::exists(file, failed)) return std::nullopt;
    return readJson(file, [&](const Json& json) {
        if (json.at("question") != question)
            throw InputError(
                file.string(),
                fmt::format("answers another question: {}; expected an empty folder, or the same question",
                            shortened(differenceOf(json.at("question"), question))));
        TradeReference reference;
        reference.how = json.at("how").get<std::string>();
        reference.relativeError = json.at("relativeError").get<double>();
        reference.pixels = json.at("pixels").get<std::vector<std::uint32_t>>();
        reference.mean = pictureFrom(json.at("mean"));
        reference.standardError = pictureFrom(json.at("standardError"));
        for (const Json& group : json.at("groups")) reference.groups.push_back(pictureFrom(group));
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
    json["groups"] = Json::array();
    for (const Picture& group : reference.groups) json["groups"].push_back(pictureJson(group));
    writeFileAtomically(folder / "reference.json", json.dump() + '\n');
}

TradeFolder mergedFolders(const std::vector<fs::path>& folders) {
    TradeFolder merged;
    std::string first;
    for (const fs::path& folder : folders) {
        const std::vector<fs::path> files = cellFiles(folder);
        if (files.empty())
            throw InputError(folder.string(),
                             "holds no cells, expected a folder that halfdisk trade -o wrote");
        for (const fs::path& file : files) {
            CellFile read = readCellFile(file);
            if (first.empty()) {
                first = file.string();
                merged.question = read.question;
                merged.truth = read.truth;
                merged.referenceWords = read.referenceWords;
                merged.target = read.target;
            } else if (read.question != merged.question) {
                throw InputError(file.string(),
                                 fmt::format("answers another question than {}: {}", first,
                                             shortened(differenceOf(read.question, merged.question))));
            }
            merged.cells.emplace(read.number, std::move(read.cell));
        }
    }
    return merged;
}

}  // namespace halfdisk
