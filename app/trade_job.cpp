#include "app/trade_job.h"

#include <fmt/format.h>

#include "app/cli_arguments.h"
#include "app/interruption.h"
#include "app/progress_bar.h"
#include "app/trade_data.h"
#include "app/trade_plots.h"
#include "app/trade_reference_file.h"
#include "app/trade_reference_store.h"
#include "app/trade_text.h"
#include "core/stopwatch.h"
#include "lessons/atomic_file.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

void makeTradeFolder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder / "cells", failed);
    if (failed || !fs::is_directory(folder / "cells", failed))
        throw InputError(fmt::format("--output: '{}' is no folder that can be made{}{}, expected a folder",
                                     excerpt(folder.string()), failed ? ": " : "",
                                     failed ? failed.message() : ""));
}

/// Writes what follows from the cells; returns the names.
std::vector<std::string> writeReport(const fs::path& folder, const TradeFolder& trade,
                                     const TradeReport& report) {
    writeFileAtomically(folder / "trade.csv", reportCsv(report));
    writeFileAtomically(folder / "trade.json", reportJson(trade, report).dump(1) + '\n');
    std::vector<std::string> names{"trade.csv", "trade.json"};
    for (const std::string& name : writeTradePlots(folder, report)) names.push_back(name);
    return names;
}

/// What a job has done and what it was asked; ends on Ctrl-C with what is there.
class TradeJob {
 public:
    explicit TradeJob(TradeRequest request) : request_(std::move(request)) {
        trade_.question = questionJson(request_);
        trade_.target = request_.target;
        if (!request_.texts.output) return;
        folder_ = *request_.texts.output;
        trade_.cells = readCells(*folder_, trade_.question);
        makeTradeFolder(*folder_);
    }

    int run() {
        ProgressBar bar;
        const Interruption interruption([&bar] { bar.say("stopping; Ctrl-C again ends at once"); });
        const StopQuestion stop = [&interruption] { return interruption.asked(); };
        watch_ = Stopwatch();
        bool stopped = false;
        try {
            bar.tell(0.0, 0.0, "reference");
            findReference(stop);
            measureAll(bar, stop);
        } catch (const Stopped&) {
            stopped = true;
        }
        return tell(stopped);
    }

 private:
    void findReference(const StopQuestion& stop) {
        const Problem problem = request_.problem(stop);
        if (folder_)
            if (auto kept = readReference(*folder_, trade_.question, pixelCount(problem.sensor)))
                reference_ = std::move(*kept);
        if (reference_.mean.empty()) {
            reference_ = newReference(problem);
            if (folder_) writeReference(*folder_, trade_.question, reference_);
        }
        trade_.referenceWords = reference_.how;
        trade_.truth = {reference_.light(), reference_.relativeError, reference_.exact(), request_.maxDepth};
    }

    TradeReference newReference(const Problem& problem) {
        if (request_.texts.reference != "auto") {
            const bool strip = !std::holds_alternative<Field>(problem.sensor);
            return referenceFromFile(request_.texts.reference,
                                     {pixelCount(problem.sensor), strip, pictureFacts(request_)});
        }
        if (auto exact = exactReference(problem)) return std::move(*exact);
        PassBudget budget = request_.budget;
        budget.rays *= kReferenceShare;
        budget.seconds *= kReferenceShare;
        if (folder_) begun_ = readBegunReference(*folder_, trade_.question, pixelCount(problem.sensor));
        try {
            return longRun(problem, budget, &begun_);
        } catch (const Stopped&) {
            if (folder_ && begun_.run.groups.passes() > 0)
                writeBegunReference(*folder_, trade_.question, begun_);
            throw;
        } catch (const NoReference& why) {
            throw InputError(fmt::format("{}: {}; expected --reference FILE, or another --sensor",
                                         request_.texts.scene, why.what()));
        }
    }

    void measureAll(ProgressBar& bar, const StopQuestion& stop) {
        std::vector<std::size_t> missing;
        for (std::size_t i = request_.part; i < request_.settings.size(); i += request_.parts)
            if (trade_.cells.count(i) == 0) missing.push_back(i);
        for (std::size_t k = 0; k < missing.size(); ++k) {
            const std::size_t i = missing[k];
            const TradeSetting& setting = request_.settings[i];
            bar.tell(
                static_cast<double>(k) / static_cast<double>(missing.size()), watch_.seconds(),
                fmt::format("{} of {} settings: {}", k, missing.size(), nameOf(setting, request_.maxDepth)));
            throwIfStopped(stop);
            trade_.cells[i] = measureCell(request_.problemOf(setting, stop), setting, request_.maxDepth,
                                          reference_, request_.budget);
            if (folder_) writeCell(*folder_, trade_, i);
        }
    }

    int tell(bool stopped) {
        const std::size_t all = request_.settings.size();
        if (stopped && (reference_.mean.empty() || trade_.cells.empty())) {
            const std::uint64_t passes = begun_.run.groups.passes();
            const std::string how =
                folder_ ? "the same command goes on with it" : "-o DIR would have kept it";
            writeError(reference_.mean.empty() && passes > 0
                           ? fmt::format("stopped: {} passes of the reference are done; {}", passes, how)
                           : "stopped before the first setting was measured");
            return kExitStopped;
        }
        const TradeReport report = reportOf(trade_);
        std::vector<std::string> names;
        if (folder_) names = writeReport(*folder_, trade_, report);
        if (request_.texts.json) {
            writeJson(reportJson(trade_, report));
        } else {
            std::string text = reportText(trade_, report);
            if (folder_)
                text += fmt::format("\nwritten to {}: {}\n", folder_->string(), fmt::join(names, ", "));
            if (trade_.cells.size() < all && request_.parts > 1 && !stopped)
                text += fmt::format(
                    "part {} of {}: {} of {} settings; halfdisk trade merge joins the parts' folders\n",
                    request_.part + 1, request_.parts, trade_.cells.size(), all);
            writeOutput(text);
        }
        if (!stopped) return kExitSuccess;
        writeError(fmt::format(
            "stopped: {} of {} settings are measured; {}", trade_.cells.size(), all,
            folder_ ? "the same command goes on with the others" : "-o DIR would have kept them"));
        return kExitStopped;
    }

    TradeRequest request_;
    std::optional<fs::path> folder_;
    TradeFolder trade_;
    TradeReference reference_;
    BegunRun begun_;  ///< of the reference
    Stopwatch watch_;
};

}  // namespace

int runTrade(TradeRequest request) {
    return TradeJob(std::move(request)).run();
}

int runTradeMerge(const TradeMergeTexts& texts) {
    const std::vector<fs::path> parts(texts.folders.begin(), texts.folders.end());
    TradeFolder trade = mergedFolders(parts);
    if (texts.target)
        trade.target = numberArgument("--target", *texts.target, kLeastTradeError, kMostTradeError);
    makeTradeFolder(texts.output);
    readCells(texts.output, trade.question);  // a folder of another question is refused
    for (const auto& numbered : trade.cells) writeCell(texts.output, trade, numbered.first);
    for (const std::string& problem : copyReference(parts, texts.output, trade.question))
        writeError(problem + " (merged without it)", true);
    const TradeReport report = reportOf(trade);
    const std::vector<std::string> names = writeReport(texts.output, trade, report);
    if (texts.json) {
        writeJson(reportJson(trade, report));
    } else {
        writeOutput(reportText(trade, report) + missingText(trade) +
                    fmt::format("\nwritten to {}: {}\n", texts.output, fmt::join(names, ", ")));
    }
    if (const std::vector<std::string> missing = missingSettings(trade); !missing.empty())
        writeError(fmt::format("{} of {} settings are in none of these folders", missing.size(),
                               missing.size() + trade.cells.size()));
    return kExitSuccess;
}

}  // namespace halfdisk
