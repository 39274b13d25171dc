// How fast does the index answer rays beside its peers, at every size?
#include <cmath>

#include "benches.h"
#include "ray_race.h"
#include "report.h"

namespace halfdisk {
namespace {

const Lap* find(const Race& race, std::string_view who) {
    for (const Lap& lap : race.laps)
        if (lap.who == who) return &lap;
    return nullptr;
}

std::string millions(const Lap* lap) {
    return lap && lap->seconds > 0.0 ? fmt::format("{:.2f}", 1e-6 / lap->seconds) : "";
}

std::string shown(double ratio) {
    return ratio > 0.0 ? fmt::format("{:.2f}", ratio) : "";
}

/// Differences of what `who` begins with, or of all others.
std::size_t differences(const Race& race, bool ofPeers) {
    std::size_t sum = 0;
    for (const Lap& lap : race.laps) {
        const bool isPeer = lap.who.starts_with("Embree") || lap.who == "Box2D";
        if (isPeer == ofPeers) sum += lap.differences;
    }
    return sum;
}

void addRow(Report& report, const PatternInfo& pattern, const Race& race, std::optional<double> required) {
    nlohmann::ordered_json row;
    row["scene"] = pattern.name;
    row["query"] = race.query->id;
    row["size"] = race.size;
    row["segments"] = race.segments;
    row["method"] = race.method;
    for (const Lap& lap : race.laps) {
        if (lap.seconds > 0.0) row["raysPerSecond"][lap.who] = 1.0 / lap.seconds;
        row["differences"][lap.who] = lap.differences;
    }
    row["checked"] = race.checked;
    if (race.overEmbree > 0.0) row["overEmbree"] = race.overEmbree;
    if (race.overEmbree > 0.0) row["embree"] = race.embree;
    if (required) row["required"] = *required;
    if (race.overBox2D > 0.0) row["overBox2D"] = race.overBox2D;
    report.add("rays", row);
}

void printTable(Report& report, const PatternInfo& pattern, const QueryInfo& query,
                const std::vector<Race>& races) {
    report.print("\n{}: {}; million rays a second\n", pattern.name, query.title);
    report.print(
        "{:>8} {:>11} {:>8} {:>6} {:>8} {:>6}  {:>7} {:>7} {:>7} {:>7} {:>6}  {:>6} {:>6} {:>6}  {}\n", "n",
        "method", "Halfdisk", "ratio", "required", "", "Embree1", "Embree2", "packets", "Box2D", "ratio",
        "brute", "tree", "grid", "differences: own, peers, of rays");
    for (const Race& race : races) {
        if (race.query != &query) continue;
        const auto required = requiredRatio(query, race.size, pattern.clustered);
        const std::string what = fmt::format("{}, {}, n = {}", pattern.name, query.title, race.size);
        std::string_view mark, boxMark;
        if (race.overEmbree > 0.0) mark = report.judge(what + ", over Embree", race.overEmbree, required);
        if (race.overBox2D > 0.0) boxMark = report.judge(what + ", over Box2D", race.overBox2D, kBox2DRatio);
        const auto speed = [&](std::string_view who) { return millions(find(race, who)); };
        report.print(
            "{:>8} {:>11} {:>8} {:>6} {:>8} {:>6}  {:>7} {:>7} {:>7} {:>7} {:>6}  {:>6} {:>6} {:>6}  {} {} "
            "of {} {}\n",
            race.segments, race.method, speed("Halfdisk"), shown(race.overEmbree),
            required ? fmt::format(">= {:.2f}", *required) : "", mark, speed("Embree, 1 triangle"),
            speed("Embree, 2 triangles"), speed("Embree, packets of 16"), speed("Box2D"),
            shown(race.overBox2D), speed("brute force"), speed("tree"), speed("grid"),
            differences(race, false), differences(race, true), race.checked,
            boxMark == "MISSED" ? "  Box2D: MISSED" : "");
        addRow(report, pattern, race, required);
    }
}

/// Slope of log(time per ray) over log(segments) from 1000 segments on, by least squares.
std::optional<double> growth(const std::vector<Race>& races, const QueryInfo& query, std::string_view who) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Race& race : races) {
        const Lap* lap = find(race, who);
        if (race.query != &query || race.size < 1000 || !lap) continue;
        const double logSize = std::log(static_cast<double>(race.segments)), logTime = std::log(lap->seconds);
        n += 1.0, x += logSize, y += logTime, xx += logSize * logSize, xy += logSize * logTime;
    }
    if (n < 2.0) return std::nullopt;
    return (n * xy - x * y) / (n * xx - x * x);
}

void printGrowth(Report& report, const PatternInfo& pattern, const std::vector<Race>& races) {
    report.print("\n{}: growth of the time per ray from 1000 segments on, as an exponent of n\n",
                 pattern.name);
    for (const QueryInfo& query : kQueries) {
        const auto own = growth(races, query, "Halfdisk"),
                   embree = growth(races, query, "Embree, 1 triangle");
        if (!own) continue;
        report.print("  {:<42} Halfdisk {:.3f}{}\n", query.title, *own,
                     embree ? fmt::format("   Embree {:.3f}", *embree) : "");
        nlohmann::ordered_json row{{"scene", pattern.name}, {"query", query.id}, {"exponent", *own}};
        if (embree) row["embree"] = *embree;
        report.add("growth", row);
    }
}

}  // namespace

void benchIndex(Report& report, Effort effort) {
    const bool full = effort == Effort::full;
    report.print(
        "Rays beside Embree and Box2D: one core, CPU time, medians and median ratios of runs in turns.\n"
        "Closest hits: from random points of the scene's bounding box into random directions; any hits: from "
        "random points to\nrandom points; batches of 4096 rays; fans of {} rays over half-disks about random "
        "points.\nEmbree1, Embree2: a segment as one tall triangle, or as two, rtcIntersect1 and "
        "rtcOccluded1; "
        "the ratio is to the faster one;\npackets: rtcIntersect16.\n",
        kFanRays);
    for (const std::string& missing : missingPeers()) report.print("{}\n", missing);
    for (const Pattern pattern : {Pattern::random, Pattern::circles, Pattern::fractal}) {
        std::vector<Race> races;
        for (const std::size_t size : kSizes) {
            if (!full && size != 16 && size != 1000) continue;
            if (full && pattern == Pattern::fractal && size != kSizes.back()) continue;
            report.progress(fmt::format("{}, n = {}", infoOf(pattern).name, size));
            for (Race& race : raceRays(pattern, size, effort)) races.push_back(std::move(race));
        }
        report.progress("");
        report.print("\n{}: {}\n", infoOf(pattern).name, infoOf(pattern).meaning);
        for (const QueryInfo& query : kQueries) printTable(report, infoOf(pattern), query, races);
        printGrowth(report, infoOf(pattern), races);
    }
}

}  // namespace halfdisk
