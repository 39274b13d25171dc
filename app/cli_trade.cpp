// halfdisk trade: what does accuracy cost in this scene? The options, their help, and the order of the work.
#include <fmt/format.h>

#include <memory>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/interruption.h"
#include "app/progress_bar.h"
#include "app/trade_data.h"
#include "app/trade_plots.h"
#include "app/trade_reference_file.h"
#include "app/trade_reference_store.h"
#include "app/trade_request.h"
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

int runMerge(const std::vector<std::string>& folders, const std::string& output,
             const std::optional<std::string>& target, bool asJson) {
    const std::vector<fs::path> parts(folders.begin(), folders.end());
    TradeFolder trade = mergedFolders(parts);
    if (target) trade.target = numberArgument("--target", *target, kLeastTradeError, kMostTradeError);
    makeTradeFolder(output);
    readCells(output, trade.question);  // a folder of another question is refused
    for (const auto& numbered : trade.cells) writeCell(output, trade, numbered.first);
    for (const std::string& problem : copyReference(parts, output, trade.question))
        writeError(problem + " (merged without it)", true);
    const TradeReport report = reportOf(trade);
    const std::vector<std::string> names = writeReport(output, trade, report);
    if (asJson) {
        writeJson(reportJson(trade, report));
    } else {
        writeOutput(reportText(trade, report) + missingText(trade) +
                    fmt::format("\nwritten to {}: {}\n", output, fmt::join(names, ", ")));
    }
    if (const std::vector<std::string> missing = missingSettings(trade); !missing.empty())
        writeError(fmt::format("{} of {} settings are in none of these folders", missing.size(),
                               missing.size() + trade.cells.size()));
    return kExitSuccess;
}

void addMerge(CLI::App& trade, Action& chosen) {
    struct Texts {
        std::vector<std::string> folders;
        std::string output;
        std::optional<std::string> target;
        bool json = false;
    };
    const auto texts = std::make_shared<Texts>();
    CLI::App* command = trade.add_subcommand("merge", "join what parts of a trade measured");
    command->add_option("DIR", texts->folders, "folders that halfdisk trade --part I/N -o DIR wrote")
        ->required()
        ->type_name("...");
    command->add_option("-o,--output", texts->output, "folder for all of it")->type_name("OUT")->required();
    command->add_option("--target", texts->target, "another relative error to reach")->type_name("REL_ERROR");
    command->add_flag("--json", texts->json, "print one JSON object");
    command->footer(
        "With --rays the result is that of an undivided run, but for the seconds. Settings that no folder\n"
        "holds are told, and so is a reference.json that is damaged; all else is joined. A damaged cell is\n"
        "refused: without its file the others are of use.\n\n"
        "Example:\n  halfdisk trade merge part-1 part-2 -o all");
    command->callback([&chosen, texts] {
        chosen = [texts] { return runMerge(texts->folders, texts->output, texts->target, texts->json); };
    });
}

void addQuestionOptions(CLI::App& command, TradeTexts& texts) {
    command.add_option("SCENE", texts.scene, "scene file (TOML)")->type_name("");
    command
        .add_option("--sensor", texts.sensor,
                    "where light is measured [eye if the scene has one, else profile]")
        ->type_name("eye|profile|field|probe");
    command.add_option("--walls", texts.walls, "of a profile: floor, box, box.2, all [all]")
        ->type_name("NAME,...");
    command.add_option("--at", texts.at, "of a probe")->type_name("X,Y|WALL:T");
    command.add_option("--normal", texts.normal, "of a probe off the walls")->type_name("X,Y");
    command.add_option("--width", texts.width, "pixels, bins, or cells across [128; of a field 48]")
        ->type_name("W");
    command.add_option("--height", texts.height, "of a field: cells up; without it, cells are squares")
        ->type_name("H");
    command.add_option("--estimators", texts.estimators, "which are compared")
        ->type_name("all|NAME,...")
        ->capture_default_str();
    command
        .add_option(
            "--sweep", texts.sweeps,
            "in place of the usual variations; may be repeated: all combinations. KEY is a parameter, "
            "ESTIMATOR.PARAMETER, depth, facets (a factor), index or precision (float, double)")
        ->type_name("KEY=V1,V2,...")
        ->allow_extra_args(false);
    command.add_option("--budget", texts.budget, fmt::format("time for each setting [{:g}]", kTradeSeconds))
        ->type_name("SECONDS");
    command
        .add_option("--rays", texts.rays,
                    "in place of --budget: so many rays for each, the same on every machine")
        ->type_name("R");
    command.add_option("--target", texts.target, "relative error to reach: RMSE over the mean of the pixels")
        ->type_name("REL_ERROR")
        ->capture_default_str();
    command
        .add_option("--reference", texts.reference,
                    "the truth: auto, or what eye, profile or field wrote of the same pixels (.json, .pfm)")
        ->type_name("auto|FILE")
        ->capture_default_str();
    command.add_option("--depth", texts.depth, std::string(kMaxDepthInfo.meaning))
        ->type_name("D")
        ->capture_default_str();
    command.add_option("--specular", texts.specular, std::string(kMaxSpecularInfo.meaning))
        ->type_name("S")
        ->capture_default_str();
    command.add_option("--seed", texts.seed, std::string(kSeedInfo.meaning))
        ->type_name("K")
        ->capture_default_str();
    command.add_option("--threads", texts.threads, std::string(kThreadsInfo.meaning))->type_name("T");
    command.add_option("--part", texts.part, "measure only the settings I, I + N, I + 2N, ...")
        ->type_name("I/N");
}

constexpr const char* kTradeFooter =
    "Every setting gets the same budget and is held against the exact light, or a long run of an estimator "
    "that leaves "
    "nothing out (its own error is told and counted in). bias: of the picture that endless passes would "
    "give, with a 95 % "
    "interval; * where it is sure. falls as: RMSE ~ passes^p, -0.5 is noise alone. off: the least factor by "
    "which it is "
    "dearer than the cheapest setting of the same error, over all errors from 100 % to 0.1 %.\n\n"
    "precision=float decides and places every hit in single precision, as a tracer in float would, without "
    "an index; the "
    "rest of the light stays in double. Up to 128 walls its time compares with double's, which asks all "
    "walls "
    "there "
    "too.\n\nWith -o DIR "
    "every setting "
    "that is done is kept; the same command goes on where it was stopped (Ctrl-C: exit code 130). DIR gets "
    "trade.csv, "
    "trade.json, and front and convergence as .svg and .png.\n\nExamples:\n  halfdisk trade room.toml\n  "
    "halfdisk trade glass.toml "
    "--sensor profile --walls floor --rays 1e6 -o glass\n  halfdisk trade room.toml --estimators radiosity "
    "--sweep "
    "patches=50,100,200,400\n  halfdisk trade room.toml --rays 1e6 --part 2/8 -o part-2\n  halfdisk trade "
    "merge part-1 part-2 -o "
    "all";

}  // namespace

void addTradeCommand(CLI::App& app, Action& chosen) {
    const auto texts = std::make_shared<TradeTexts>();
    CLI::App* command =
        app.add_subcommand("trade", "measure what accuracy costs: every estimator on equal budgets");
    addQuestionOptions(*command, *texts);
    command->add_option("-o,--output", texts->output, "folder for cells, tables and plots")->type_name("DIR");
    command->add_flag("--json", texts->json, "print one JSON object");
    command->require_subcommand(0, 1);
    addMerge(*command, chosen);
    command->footer(kTradeFooter);
    command->callback([&chosen, texts, command] {
        if (!command->get_subcommands().empty()) return;
        chosen = [texts] {
            if (texts->scene.empty())
                throw InputError("trade needs a scene file, expected halfdisk trade SCENE");
            return TradeJob(tradeRequest(*texts)).run();
        };
    });
}

}  // namespace halfdisk
