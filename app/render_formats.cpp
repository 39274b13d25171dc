// How does a rendering read as PNG, PFM, CSV and JSON?
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "app/pfm_image.h"
#include "app/render_output.h"
#include "app/render_result.h"
#include "app/tone.h"

namespace halfdisk {
namespace {

/// A strip's row is repeated over the height.
LinearImage linearImage(const RenderResult& result) {
    LinearImage image{result.picture.width, result.picture.height, meansOf(result.measurement.film)};
    const std::vector<Rgb> row = image.pixels;
    const std::size_t whole = static_cast<std::size_t>(image.width) * image.height;
    image.pixels.reserve(whole);
    while (image.pixels.size() < whole) image.pixels.insert(image.pixels.end(), row.begin(), row.end());
    return image;
}

void appendCsv(std::string& text, const Rgb& value) {
    for (int c = 0; c < 3; ++c) fmt::format_to(std::back_inserter(text), ",{}", numberText(value[c]));
}

/// [r,g,b]
void appendJson(std::string& text, const Rgb& value) {
    for (int c = 0; c < 3; ++c) {
        text += c == 0 ? '[' : ',';
        text += std::isfinite(value[c]) ? numberText(value[c]) : std::string("null");
    }
    text += ']';
}

}  // namespace

std::string pngOf(const RenderResult& result) {
    return encodePng(toned(linearImage(result), result.scale));
}

std::string pfmOf(const RenderResult& result) {
    return encodePfm(linearImage(result));
}

std::string csvOf(const RenderResult& result) {
    std::string text;
    const Json facts = resultFacts(result);
    for (const auto& fact : facts.items())
        text += fmt::format("# {} = {}\n", fact.key(),
                            fact.value().dump(-1, ' ', false, Json::error_handler_t::replace));
    const std::vector<std::string_view> columns = placeColumns(result.picture.sensor);
    text += fmt::format("pixel,{},r,g,b,errorR,errorG,errorB\n", fmt::join(columns, ","));
    const PixelPlaces places(result.picture.sensor, result.index);
    const PixelStatistics& pixels = result.measurement.film.pixels;
    for (std::uint32_t pixel = 0; pixel < pixels.size(); ++pixel) {
        fmt::format_to(std::back_inserter(text), "{}", pixel);
        const std::array<double, 2> place = places.at(pixel);
        for (std::size_t i = 0; i < columns.size(); ++i)
            fmt::format_to(std::back_inserter(text), ",{}", numberText(place[i]));
        appendCsv(text, pixels[pixel].mean);
        if (hasError(pixels[pixel])) {
            appendCsv(text, pixels[pixel].standardError());
        } else {
            text += ",,,";
        }
        text += '\n';
    }
    return text;
}

// The long arrays are text from the start: as objects they would take ten times the memory.
std::string jsonOfResult(const RenderResult& result) {
    std::string text = resultFacts(result).dump(-1, ' ', false, Json::error_handler_t::replace);
    text.pop_back();
    const PixelStatistics& pixels = result.measurement.film.pixels;
    text += ",\n\"mean\":[";
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i > 0) text += ',';
        appendJson(text, pixels[i].mean);
    }
    text += "],\n\"standardError\":[";
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i > 0) text += ',';
        if (hasError(pixels[i])) {
            appendJson(text, pixels[i].standardError());
        } else {
            text += "null";
        }
    }
    text += "]}\n";
    return text;
}

}  // namespace halfdisk
