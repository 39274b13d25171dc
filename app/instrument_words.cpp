#include "app/instrument_words.h"

#include <fmt/format.h>

#include "app/csv_text.h"
#include "app/language.h"

namespace halfdisk {
namespace {

constexpr std::string_view kProduct = "Halfdisk";

std::string share(std::uint64_t count, std::uint64_t all) {
    if (count == 0) return "0";
    return say("{} ({:.2g} %)", count, 100.0 * static_cast<double>(count) / static_cast<double>(all));
}

std::string percent(double part) {
    return part == 0.0 ? "0" : say("{:.2g} %", 100.0 * part);
}

}  // namespace

std::vector<DialLine> dialLines(const DialAnswer& answer) {
    const ExtremeCounts &chosen = answer.chosen, &product = answer.product;
    const auto counted = [&](LostRay::How how, std::uint64_t ExtremeCounts::*what, std::string_view name,
                             std::string_view meaning) {
        return DialLine{std::string(tr(name)),
                        share(chosen.*what, chosen.rays),
                        share(product.*what, product.rays),
                        chosen.*what > 0,
                        meaning,
                        how};
    };
    // More than the bounds of the product's own errors: see core/extremes.
    constexpr double kVisible = 1e-6;
    return {counted(LostRay::How::leak, &ExtremeCounts::leaks, "leak",
                    "rays that pass through a wall, or meet something beyond the one that is there"),
            counted(LostRay::How::selfHit, &ExtremeCounts::selfHits, "hit their own wall",
                    "rays that meet the wall they just left"),
            counted(LostRay::How::nonFinite, &ExtremeCounts::nonFinite, "not a number",
                    "NaN or infinity where there should be one"),
            DialLine{std::string(tr("hits are off by")), percent(chosen.place), percent(product.place),
                     chosen.place > kVisible, "of the others: the most, as a share of the scene's size"},
            DialLine{std::string(tr("light is off by")), percent(chosen.light), percent(product.light),
                     chosen.light > kVisible, "the light that all rays together see"}};
}

std::string dialVerdict(const DialAnswer& answer) {
    if (!answer.refusal.empty()) return say("Nothing is counted: {}.", answer.refusal);
    const ExtremeCounts &chosen = answer.chosen, &product = answer.product;
    if (chosen.rays == 0) return std::string(tr("There is no wall to leave."));
    const auto part = [](const ExtremeCounts& counts) {
        return 100.0 * static_cast<double>(counts.faults()) / static_cast<double>(counts.rays);
    };
    if (chosen.faults() == 0) return say("None of {} rays goes wrong here.", chosen.rays);
    if (product.faults() == 0)
        return say("Of {} rays {:.2g} % go wrong; of Halfdisk's own none.", chosen.rays, part(chosen));
    return say("Of {} rays {:.2g} % go wrong; of Halfdisk's own {:.2g} %.", chosen.rays, part(chosen),
               part(product));
}

std::string extremesWords(const AppState& state) {
    const auto& answer = state.answer ? state.answer->instruments.dial : nullptr;
    if (!answer) return std::string(tr("It is not known yet."));
    std::string words = dialVerdict(*answer);
    for (const DialLine& line : dialLines(*answer))
        words += fmt::format("\n{}: {}; {} {}", line.name, line.chosen, kProduct, line.product);
    return words;
}

std::string extremesTable(const AppState& state) {
    CsvText table(
        {"tracer", "rays", "leaks", "self_hits", "non_finite", "hits_off_by_sizes", "light_off_by_share"});
    const auto& answer = state.answer ? state.answer->instruments.dial : nullptr;
    if (!answer || !answer->refusal.empty()) return table.text();
    const auto row = [&](std::string_view tracer, const ExtremeCounts& counts) {
        table.cell(tracer);
        for (const std::uint64_t count : {counts.rays, counts.leaks, counts.selfHits, counts.nonFinite})
            table.cell(static_cast<double>(count));
        table.cell(counts.place).cell(counts.light).endRow();
    };
    row(fmt::format("{} {}", nameOf(kPrecisions, answer->setting.precision),
                    nameOf(kEpsilonPolicies, answer->setting.policy)),
        answer->chosen);
    row("halfdisk", answer->product);
    return table.text();
}

}  // namespace halfdisk
