#include "app/trade_json.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace halfdisk {

double numberFrom(const Json& json) {
    return json.is_null() ? std::nan("") : json.get<double>();
}

Json uncertainJson(const Uncertain& number) {
    return Json::array({jsonOf(number.value), jsonOf(number.error)});
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

std::string textOfTradeFile(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    if (!stream) throw InputError(file.string(), "cannot be read");
    return text;
}

std::string damagedTradeFile() {
    return "is damaged, or not what halfdisk trade wrote; without this file the others are of use: delete "
           "it, "
           "and the same command measures it again";
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
