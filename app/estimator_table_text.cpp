// How is the table of estimators told, to people and to scripts?
#include <fmt/format.h>

#include <algorithm>

#include "app/estimator_arguments.h"
#include "app/estimator_table.h"

namespace halfdisk {
namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kLabelWidth = 20;  // what stands before the texts

/// `label` in its column, then `text` broken between words, later lines indented alike.
std::string block(std::string_view label, std::string_view text) {
    std::string lines = fmt::format("  {:<{}}", label, kLabelWidth - 2);
    if (label.size() + 4 > kLabelWidth) lines += fmt::format("\n{:{}}", "", kLabelWidth);
    std::size_t column = kLabelWidth;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        const std::string_view word = text.substr(start, end - start);
        if (column > kLabelWidth && column + 1 + word.size() > kColumns) {
            lines += fmt::format("\n{:{}}", "", kLabelWidth);
            column = kLabelWidth;
        } else if (column > kLabelWidth) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += word.size();
        start = end + 1;
    }
    return lines + "\n";
}

std::string paramText(const ParamInfo& param) {
    return fmt::format("{} ({}, default {})", param.meaning, paramRange(param),
                       paramText(param, param.initial));
}

/// The sensors that share `paths` and `refusal`: `probe, eye`.
std::string sensorsAlike(const EstimatorRow& row, const SensorAbility& ability) {
    std::string names;
    for (const SensorAbility& other : row.sensors)
        if (other.paths == ability.paths && other.refusal == ability.refusal)
            names += fmt::format("{}{}", names.empty() ? "" : ", ", other.sensor);
    return names;
}

std::string abilities(const EstimatorRow& row) {
    std::string lines;
    for (std::size_t i = 0; i < row.sensors.size(); ++i) {
        const SensorAbility& ability = row.sensors[i];
        const bool toldBefore =
            std::any_of(row.sensors.begin(), row.sensors.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const SensorAbility& earlier) {
                            return earlier.paths == ability.paths && earlier.refusal == ability.refusal;
                        });
        if (toldBefore) continue;
        const std::string sensors = sensorsAlike(row, ability);
        lines += ability.refusal.empty()
                     ? block("paths", fmt::format("{}   ({})", ability.paths, sensors))
                     : block("cannot work", fmt::format("{}   ({})", ability.refusal, sensors));
    }
    return lines;
}

Json paramJson(const ParamInfo& param) {
    Json object{{"name", std::string(param.name)},
                {"meaning", std::string(param.meaning)},
                {"unit", std::string(param.unit)}};
    if (param.choices.empty()) {
        object["least"] = param.least;
        object["most"] = param.most;
        object["initial"] = param.initial;
        object["whole"] = param.whole;
        return object;
    }
    object["initial"] = paramText(param, param.initial);
    for (const std::string_view choice : param.choices) object["choices"].push_back(std::string(choice));
    return object;
}

}  // namespace

Json rowsJson(const std::vector<EstimatorRow>& rows) {
    Json list = Json::array();
    for (const EstimatorRow& row : rows) {
        const EstimatorInfo& info = *row.info;
        Json object{{"id", std::string(info.id)},
                    {"title", std::string(info.title)},
                    {"meaning", std::string(info.meaning)},
                    {"bias", info.bias.empty() ? Json(nullptr) : Json(std::string(info.bias))},
                    {"sensors", Json::object()},
                    {"params", Json::array()}};
        for (const SensorAbility& ability : row.sensors)
            object["sensors"][std::string(ability.sensor)] = {
                {"paths", ability.paths},
                {"refusal", ability.refusal.empty() ? Json(nullptr) : Json(ability.refusal)}};
        for (const ParamInfo& param : info.params) object["params"].push_back(paramJson(param));
        list.push_back(object);
    }
    return list;
}

std::string rowsText(const std::vector<EstimatorRow>& rows, const std::string& file) {
    std::string text =
        fmt::format("Scene: {}\nPaths: L light, D matt or glossy wall, S mirror or glass, E sensor\n",
                    file.empty() ? "one that has everything" : file);
    for (const EstimatorRow& row : rows) {
        const EstimatorInfo& info = *row.info;
        text += fmt::format("\n{}: {}\n", info.id, info.title) + block("", info.meaning) + abilities(row);
        text += block("bias", info.bias.empty() ? "none" : info.bias);
        if (!info.params.empty()) text += "  --param\n";
        for (const ParamInfo& param : info.params)
            text += block(fmt::format("  {}", param.name), paramText(param));
    }
    return text;
}

}  // namespace halfdisk
