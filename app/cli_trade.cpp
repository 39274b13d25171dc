// halfdisk trade: what does accuracy cost in this scene? The options and their help.
#include <fmt/format.h>

#include <memory>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/trade_job.h"
#include "app/trade_request.h"
#include "lessons/input_error.h"

namespace halfdisk {
namespace {

void addMerge(CLI::App& trade, Action& chosen) {
    const auto texts = std::make_shared<TradeMergeTexts>();
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
    command->callback([&chosen, texts] { chosen = [texts] { return runTradeMerge(*texts); }; });
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

// clang-format off
constexpr const char* kTradeFooter =
    "Every setting gets the same budget and is held against the exact light, or a long run of an estimator that leaves "
    "nothing out (its own error is told and counted in). bias: of the picture that endless passes would give, with a "
    "95 % interval; * where it is sure. falls as: RMSE ~ passes^p, -0.5 is noise alone. off: the least factor by which "
    "it is dearer than the cheapest setting of the same error, over all errors from 100 % to 0.1 %.\n\n"
    "precision=float decides and places every hit in single precision, as a tracer in float would, without an index; "
    "the rest of the light stays in double. Up to 128 walls its time compares with double's, which asks all walls "
    "there too.\n\n"
    "With -o DIR every setting that is done is kept; the same command goes on where it was stopped (Ctrl-C: exit code "
    "130). DIR gets trade.csv, trade.json, and front and convergence as .svg and .png.\n\n"
    "Examples:\n"
    "  halfdisk trade room.toml\n"
    "  halfdisk trade glass.toml --sensor profile --walls floor --rays 1e6 -o glass\n"
    "  halfdisk trade room.toml --estimators radiosity --sweep patches=50,100,200,400\n"
    "  halfdisk trade room.toml --rays 1e6 --part 2/8 -o part-2\n"
    "  halfdisk trade merge part-1 part-2 -o all";
// clang-format on

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
            return runTrade(tradeRequest(*texts));
        };
    });
}

}  // namespace halfdisk
