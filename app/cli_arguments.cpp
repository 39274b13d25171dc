#include "app/cli_arguments.h"

#include "app/language.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <thread>
#include <utility>

#include "lessons/scene_keys.h"

namespace halfdisk {
namespace {

constexpr std::string_view kDigits = "0123456789";

bool isDigits(std::string_view text) {
    return !text.empty() && text.find_first_not_of(kDigits) == std::string_view::npos;
}

std::optional<std::uint64_t> parseDigits(std::string_view digits) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t number = 0;
    for (const char c : digits) {
        const auto digit = static_cast<std::uint64_t>(c - '0');
        if (number > (kMost - digit) / 10) return std::nullopt;
        number = 10 * number + digit;
    }
    return number;
}

/// The two texts around the only `separator`.
std::optional<std::pair<std::string_view, std::string_view>> halves(std::string_view text, char separator) {
    const std::size_t at = text.find(separator);
    if (at == std::string_view::npos || text.find(separator, at + 1) != std::string_view::npos)
        return std::nullopt;
    return std::pair{text.substr(0, at), text.substr(at + 1)};
}

std::optional<Vec2> parsePair(std::string_view text) {
    const auto parts = halves(text, ',');
    if (!parts) return std::nullopt;
    const auto x = parseNumber(parts->first), y = parseNumber(parts->second);
    if (!x || !y) return std::nullopt;
    return Vec2{*x, *y};
}

bool withinRule(double value, const NumberRule& rule) {
    return value >= rule.least && value <= rule.most;
}

std::optional<int> parsePixels(std::string_view text) {
    const auto pixels = isDigits(text) ? parseDigits(text) : std::nullopt;
    if (!pixels || *pixels < kLeastPictureSize || *pixels > kMostPictureSize) return std::nullopt;
    return static_cast<int>(*pixels);
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789.eE+-") != std::string_view::npos)
        return std::nullopt;
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    double number = 0.0;
    if (!(stream >> number) || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
    if (!std::isfinite(number)) return std::nullopt;
    return number;
}

std::optional<std::uint64_t> parseWhole(std::string_view text) {
    if (isDigits(text)) return parseDigits(text);
    constexpr double kMostExact = 0x1p53;  // above, a double does not tell neighbours apart
    const std::optional<double> number = parseNumber(text);
    const bool whole = number && *number >= 0.0 && *number <= kMostExact && std::floor(*number) == *number;
    if (!whole || text.find_first_of("eE") == std::string_view::npos) return std::nullopt;
    return static_cast<std::uint64_t>(*number);
}

void failArgument(std::string_view option, std::string_view text, std::string_view problem) {
    throw InputError(fmt::format("{}: '{}' {}", option, excerpt(text), problem));
}

double numberArgument(std::string_view option, std::string_view text, double least, double most) {
    const std::optional<double> number = parseNumber(text);
    if (!number || *number < least || *number > most)
        failArgument(option, text, fmt::format("is not a number from {} to {}", least, most));
    return *number;
}

std::uint64_t wholeArgument(std::string_view option, std::string_view text, const NumberInfo& info) {
    const std::optional<std::uint64_t> number = parseWhole(text);
    if (!number || *number < info.least || *number > info.most)
        failArgument(option, text, fmt::format("is not a whole number from {} to {}", info.least, info.most));
    return *number;
}

unsigned threadsArgument(const std::optional<std::string>& text) {
    if (text) return static_cast<unsigned>(wholeArgument("--threads", *text, kThreadsInfo));
    return std::clamp(std::thread::hardware_concurrency(), 1u, static_cast<unsigned>(kThreadsInfo.most));
}

Vec2 pointArgument(std::string_view option, std::string_view text, std::string_view expected) {
    const std::optional<Vec2> point = parsePair(text);
    if (!point) failArgument(option, text, fmt::format("is not a point, expected {}", expected));
    if (!withinRule(point->x, kCoordinateRule) || !withinRule(point->y, kCoordinateRule))
        failArgument(
            option, text,
            fmt::format("is too far away, expected coordinates that are each {}", kCoordinateRule.expected));
    return *point;
}

Vec2 directionArgument(std::string_view option, std::string_view text) {
    const std::optional<Vec2> direction = parsePair(text);
    if (!direction) failArgument(option, text, "is not a direction, expected X,Y");
    const double largest = std::max(std::abs(direction->x), std::abs(direction->y));
    if (largest == 0.0) failArgument(option, text, "has no direction, expected X,Y that are not both 0");
    return glm::normalize(*direction / largest);  // scaled first: squares neither overflow nor vanish
}

std::string languageArgument(std::string_view option, std::string_view text) {
    std::vector<std::string> codes{"en"};
    for (const Language& language : loadLanguages()) codes.push_back(language.code);
    if (text.empty() || text == codes.front()) return {};
    if (std::find(codes.begin(), codes.end(), text) == codes.end())
        failArgument(option, text,
                     fmt::format("is no language that there is, expected one of {}", fmt::join(codes, ", ")));
    return std::string(text);
}

PictureSize sizeArgument(std::string_view option, std::string_view text) {
    const auto parts = halves(text, 'x');
    const auto width = parts ? parsePixels(parts->first) : std::nullopt;
    const auto height = parts ? parsePixels(parts->second) : std::nullopt;
    if (!width || !height)
        failArgument(
            option, text,
            fmt::format("is not a size, expected WxH with whole numbers from {} to {}, e.g. 1280x800",
                        kLeastPictureSize, kMostPictureSize));
    return {*width, *height};
}

DefectSet defectsArgument(std::string_view option, std::string_view text) {
    DefectSet defects;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        defects.set(namedArgument(option, text.substr(start, end - start), kDefects), true);
        start = end + 1;
    }
    return defects;
}

}  // namespace halfdisk
