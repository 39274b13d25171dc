#include "app/trade_json.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "app/fingerprint.h"
#include "lessons/atomic_file.h"

namespace halfdisk {
namespace {

constexpr const char* kFingerprint = "fingerprint";

std::string textOf(const std::filesystem::path& file) {
    if (std::filesystem::is_directory(file))
        throw InputError(file.string(), "is a folder, expected a file that halfdisk trade wrote");
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed))
        throw InputError(file.string(),
                         "is no file that can be read, expected one that halfdisk trade wrote");
    std::ifstream stream(file, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    if (!stream) throw InputError(file.string(), "cannot be read, expected a file that halfdisk trade wrote");
    return text;
}

}  // namespace

double numberOrNan(const Json& json) {
    return json.is_null() ? std::nan("") : json.get<double>();
}

Json uncertainJson(const Uncertain& number) {
    return Json::array({jsonOf(number.value), jsonOf(number.error)});
}

Uncertain uncertainFrom(const Json& json) {
    return {numberOrNan(json.at(0)), numberOrNan(json.at(1))};
}

Json pictureJson(const Picture& picture) {
    Json pixels = Json::array();
    for (const Rgb& pixel : picture) pixels.push_back(jsonOf(pixel));
    return pixels;
}

Picture pictureFrom(const Json& json) {
    Picture picture;
    for (const Json& pixel : json)
        picture.push_back({pixel.at(0).get<double>(), pixel.at(1).get<double>(), pixel.at(2).get<double>()});
    return picture;
}

void failDamaged(const std::filesystem::path& file) {
    throw InputError(file.string(),
                     "is damaged, or not what halfdisk trade wrote; without this file the others are of use: "
                     "delete it, and what it held is measured again by the command that wrote it");
}

void writeTradeFile(const std::filesystem::path& file, Json json, int indent) {
    json.erase(kFingerprint);
    json[kFingerprint] = fingerprintOf(json.dump());
    writeFileAtomically(file, json.dump(indent) + '\n');
}

Json unchangedFrom(const std::filesystem::path& file) {
    Json json = Json::parse(textOf(file));
    const std::string fingerprint = json.at(kFingerprint).get<std::string>();
    json.erase(kFingerprint);
    if (fingerprintOf(json.dump()) != fingerprint) failDamaged(file);
    return json;
}

std::string differenceOf(const Json& here, const Json& asked) {
    for (const auto& item : asked.items())
        if (!here.contains(item.key()) || here[item.key()] != item.value()) {
            if (item.key() == "settings") return "it compares other settings (--estimators, --sweep)";
            std::string text = fmt::format("its {} is {}, not {}", item.key(),
                                           here.contains(item.key()) ? here[item.key()].dump() : "unknown",
                                           item.value().dump());
            constexpr std::size_t kMost = 200;
            return text.size() > kMost ? text.substr(0, kMost) + " ..." : text;
        }
    return "it is about something else";
}

void requireQuestion(const std::filesystem::path& file, const Json& here, const Json& asked) {
    if (here == asked) return;
    throw InputError(
        file.string(),
        fmt::format("answers another question: {}; expected an empty folder, or the same question",
                    differenceOf(here, asked)));
}

}  // namespace halfdisk
