// How does a folder keep what was measured, cell by cell, so that work can be shared, stopped and gone on
// with?
#include "app/trade_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/trade_json.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

std::string cellName(std::size_t number) {
    return fmt::format("{:04}.json", number);
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
    for (std::size_t i = 0; i < setting.params.size(); ++i) {
        const ParamInfo& info = setting.estimator->params[i];
        const double most = info.choices.empty() ? info.most : static_cast<double>(info.choices.size()) - 1.0;
        if (!(setting.params[i] >= info.least && setting.params[i] <= most)) failDamaged(file);
    }
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
    cell.secondsError = json.at("secondsError").get<double>();
    cell.paceSeconds = json.at("paceSeconds").get<double>();
    cell.unseen = numberOrNan(json.at("unseen"));
    cell.statistics.variance = uncertainFrom(json.at("variance"));
    cell.statistics.bias2 = uncertainFrom(json.at("bias2"));
    cell.statistics.noise = numberOrNan(json.at("noise"));
    cell.statistics.mse = uncertainFrom(json.at("groupMse"));
    cell.statistics.mean = numberOrNan(json.at("mean"));
    for (const Json& level : json.at("levels"))
        cell.levels.push_back({level.at(0).get<double>(),
                               {numberOrNan(level.at(1)), numberOrNan(level.at(2))},
                               level.at(3).get<std::uint64_t>()});
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
    return readTradeFile(file, [&](const Json& json) {
        const Json& truth = json.at("truth");
        const std::uint64_t number = json.at("number").get<std::uint64_t>();
        const Json& names = json.at("question").at("settings");
        if (number >= names.size() || names[number] != json.at("cell").at("name") ||
            file.filename() != cellName(number))
            failDamaged(file);
        return CellFile{json.at("question"),
                        {truth.at("light").get<double>(), truth.at("relativeError").get<double>(),
                         truth.at("exact").get<bool>(), json.at("question").at("depth").get<std::uint32_t>()},
                        truth.at("reference").get<std::string>(),
                        json.at("target").get<double>(),
                        number,
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

std::vector<std::string> missingSettings(const TradeFolder& trade) {
    const Json& settings = trade.question.at("settings");
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (trade.cells.count(i) == 0) missing.push_back(settings[i].get<std::string>());
    return missing;
}

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
    json["secondsError"] = cell.secondsError;
    json["paceSeconds"] = cell.paceSeconds;
    json["unseen"] = jsonOf(cell.unseen);
    json["variance"] = uncertainJson(cell.statistics.variance);
    json["bias2"] = uncertainJson(cell.statistics.bias2);
    json["noise"] = jsonOf(cell.statistics.noise);
    json["groupMse"] = uncertainJson(cell.statistics.mse);
    json["mean"] = jsonOf(cell.statistics.mean);
    json["levels"] = Json::array();
    for (const TradeLevel& level : cell.levels)
        json["levels"].push_back(
            {level.passes, jsonOf(level.mse.value), jsonOf(level.mse.error), level.rays});
    json["exponent"] = cell.exponent ? uncertainJson(*cell.exponent) : Json(nullptr);
    return json;
}

std::map<std::size_t, TradeCell> readCells(const fs::path& folder, const Json& question) {
    std::map<std::size_t, TradeCell> cells;
    for (const fs::path& file : cellFiles(folder)) {
        CellFile read = readCellFile(file);
        requireQuestion(file, read.question, question);
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
    writeTradeFile(folder / "cells" / cellName(number), std::move(json), 1);
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
                throw InputError(file.string(), fmt::format("answers another question than {}: {}", first,
                                                            differenceOf(read.question, merged.question)));
            }
            if (merged.truth.light > 0.0)
                merged.truthSpread = std::max(
                    merged.truthSpread, std::abs(read.truth.light - merged.truth.light) / merged.truth.light);
            merged.cells.emplace(read.number, std::move(read.cell));
        }
    }
    return merged;
}

}  // namespace halfdisk
