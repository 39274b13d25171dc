#include "app/sample_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/picture_stages.h"
#include "app/shown_pictures.h"

namespace halfdisk {
namespace {

std::string pathName(Run run, std::uint32_t number) {
    if (run == Run::light)
        return number == 0 ? std::string(tr("straight from the lights")) : say("path {}", number);
    return run == Run::bidirectional ? say("pair {}", number + 1) : say("path {}", number + 1);
}

/// By which way its light came.
std::string wayWords(const SampleRow& row) {
    if (row.finds == 0) return std::string(tr("it brought nothing"));
    if (row.finds == 1) return say("its light came by {}", row.word);
    return say("its light came {} times, most by {}", row.finds, row.word);
}

const SampleRow* brightest(const LightAnswer& answer) {
    if (!answer.rows || answer.rows->empty()) return nullptr;
    const auto most =
        std::max_element(answer.rows->begin(), answer.rows->end(),
                         [](const SampleRow& a, const SampleRow& b) { return gray(a.adds) < gray(b.adds); });
    return gray(most->adds) > 0.0 ? &*most : nullptr;
}

}  // namespace

std::string sampleName(const LightAnswer& answer, const SampleRow& row) {
    const auto& names = answer.asked.scene->scene.segmentNames;
    const std::string wall = row.segment == kNoSegment ? std::string(tr("the sky")) : names[row.segment];
    switch (row.kind) {
        case SampleRow::Kind::path:
            if (answer.asked.run == Run::photonMap)
                return answer.pathRun->record.events[row.event - 1].carried == Carried::power
                           ? say("photon {}", row.number + 1)
                           : say("look {}", row.number + 1);
            return pathName(answer.asked.run, row.number);
        case SampleRow::Kind::light:
            return row.segment == kNoSegment ? std::string(tr("shadow ray to a light"))
                                             : say("shadow ray to {}", wall);
        case SampleRow::Kind::halfDisk:
            break;
    }
    constexpr double kDegrees = 180.0 / kPi;
    return say("n = {}: {:.0f}\u00b0, {}", row.number, 90.0 - row.theta * kDegrees, wall);
}

Rgb sampleValue(const LightAnswer& answer, const SampleRow& row) {
    return pixelOf(answer) ? row.adds * static_cast<double>(answer.pathRun->divisor) : row.adds;
}

std::string sampleNumber(const LightAnswer& answer, const SampleRow& row, double most) {
    constexpr double kNothing = 1e-12;
    const double adds = std::max({std::abs(row.adds.x), std::abs(row.adds.y), std::abs(row.adds.z)});
    if (adds > 0.0 && adds < kNothing * most) return "\u2248 0";
    const Rgb value = sampleValue(answer, row);
    return pixelOf(answer) ? shown(gray(value)) : shown(value);
}

std::string sampleMeaning(const LightAnswer& answer, const SampleRow& row) {
    const std::string value = shown(sampleValue(answer, row));
    if (row.kind == SampleRow::Kind::halfDisk)
        return say("brings {} W/(m rad), adds {} W/m to E; click: to its step", shown(row.brings), value);
    if (row.kind == SampleRow::Kind::light) return say("adds {} W/m to E; click: to its step", value);
    if (!pixelOf(answer) && answer.asked.run == Run::photonMap)
        return say("adds {} W/m to E; click: to its step", value);
    if (!pixelOf(answer)) return say("adds {} W/m to E: {}; click: to its step", value, wayWords(row));
    if (answer.asked.run == Run::photonMap)
        return say("adds {} W/(m rad) to the pixel's sum; click: to its step", value);
    return say("adds {} W/(m rad) to the pixel's sum: {}; click: to its step", value, wayWords(row));
}

bool isOfRow(const LightAnswer& answer, const SampleRow& row, std::size_t event) {
    if (row.kind != SampleRow::Kind::path || !answer.pathRun) return event + 1 == row.event;
    const auto& events = answer.pathRun->record.events;
    if (event >= events.size()) return false;
    const std::uint32_t path = events[event].path;
    return (answer.asked.run == Run::bidirectional ? path / 2 : path) == row.number;
}

std::string whosePixel(const LightAnswer& answer) {
    const LightQuestion& asked = answer.asked;
    if (!pixelOf(answer) || !asked.makers.second) return "";
    const Maker first = asked.makers.first.value_or(usualMaker(View::eye));
    const bool isSecond = asked.pixelOf == Side::second;
    const Maker &own = isSecond ? *asked.makers.second : first,
                &other = isSecond ? first : *asked.makers.second;
    const std::string title = fmt::format("{}: {}", nameOf(kSides, asked.pixelOf), makerTitle(own, &other));
    const std::string_view told = nameOf(kRuns, asked.run);
    if (own.estimator == told) return title;
    return say("{}; its paths by {}", title, tr(findEstimator(told)->title));
}

std::string pixelSumWords(const LightAnswer& answer) {
    const PathRun& run = *answer.pathRun;
    const double L = gray(run.estimate);
    if (!run.refusal.empty()) return say("Pixel {}", *answer.asked.pixel);
    if (run.divisor == 1)
        return say("Pixel {}: the sum is its L = {} W/(m rad)", *answer.asked.pixel, shown(L));
    return say("Pixel {}: {} paths, sum {} / {} = L = {} W/(m rad)", *answer.asked.pixel, run.divisor,
               shown(run.divisor * L), run.divisor, shown(L));
}

std::string shortPixelSumWords(const LightAnswer& answer, bool unit) {
    const PathRun& run = *answer.pathRun;
    const double L = gray(run.estimate);
    std::string words = !run.refusal.empty() ? say("Pixel {}", *answer.asked.pixel)
                        : run.divisor == 1   ? say("Pixel {}: L = {}", *answer.asked.pixel, shown(L))
                                             : say("Pixel {}: {} / {} = {}", *answer.asked.pixel,
                                                   shown(run.divisor * L), run.divisor, shown(L));
    if (unit && run.refusal.empty()) words += " W/(m rad)";
    return words;
}

std::string pixelSumMeaning(const LightAnswer& answer) {
    const PathRun& run = *answer.pathRun;
    if (!run.refusal.empty()) return run.refusal;
    std::string words = say("Pixel {} of the eye's strip, counted from 0 at its left, by {}. In W/(m rad).",
                            *answer.asked.pixel, nameOf(kRuns, answer.asked.run));
    if (!isGray(run.estimate)) words += say(" L in R, G, B: {}.", shown(run.estimate));
    if (run.record.truncated) words += tr(" The list lacks the later paths; the sum does not.");
    const SampleRow* most = brightest(answer);
    if (most && gray(run.estimate) > 0.0)
        words += say(" Most comes by {}: {:.0f} %.", sampleName(answer, *most),
                     100.0 * gray(most->adds) / gray(run.estimate));
    return words;
}

}  // namespace halfdisk
