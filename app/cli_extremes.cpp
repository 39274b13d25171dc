// halfdisk extremes: what holds at the edges, where does a naive program break, and by how much?
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/cli_actions.h"
#include "app/cli_commands.h"
#include "app/cli_output.h"
#include "app/extremes_report.h"
#include "app/interruption.h"
#include "app/progress_bar.h"
#include "core/stopwatch.h"
#include "lessons/input_error.h"
#include "lessons/scene_file.h"

namespace halfdisk {
namespace {

struct ExtremesTexts {
    std::string file;
    std::vector<std::string> only;
    bool json = false, list = false;
};

/// Those that `only` names, by id or by row; all if it is empty.
std::vector<ExtremeCell> chosenCells(std::vector<ExtremeCell> cells, const std::vector<std::string>& only) {
    if (only.empty()) return cells;
    const auto names = [](const std::string& name, const ExtremeCell& cell) {
        return cell.id == name || rowOf(cell) == name;
    };
    for (const std::string& name : only)
        if (std::none_of(cells.begin(), cells.end(),
                         [&](const ExtremeCell& cell) { return names(name, cell); }))
            throw InputError(
                fmt::format("--only {}: there is no such row; expected one of {}", name, rowNames(cells)));
    std::erase_if(cells, [&](const ExtremeCell& cell) {
        return std::none_of(only.begin(), only.end(),
                            [&](const std::string& name) { return names(name, cell); });
    });
    return cells;
}

std::vector<ExtremeLine> measureCells(const std::vector<ExtremeCell>& cells, bool& stopped) {
    ProgressBar bar;
    const Interruption interruption([&bar] { bar.say("stopping; Ctrl-C again ends at once"); });
    const Stopwatch all;
    std::vector<ExtremeLine> lines;
    for (const ExtremeCell& cell : cells) {
        bar.tell(static_cast<double>(lines.size()) / static_cast<double>(cells.size()), all.seconds(),
                 cell.id);
        const Stopwatch watch;
        try {
            const ExtremeOutcome outcome = cell.run([&] { return interruption.asked(); });
            lines.push_back({&cell, outcome, holds(cell, outcome), watch.seconds()});
        } catch (const Stopped&) {
            stopped = true;
            break;
        }
    }
    return lines;
}

std::vector<ExtremeCell> cellsOfFile(const std::string& file) {
    const Scene scene = expandScene(loadScene(file));
    if (scene.segments.empty())
        throw InputError(file, "the scene has no wall, expected one at least: rays start at walls");
    return extremeCellsOf(scene);
}

int runExtremes(const ExtremesTexts& texts) {
    const auto cells = chosenCells(texts.file.empty() ? extremeCells() : cellsOfFile(texts.file), texts.only);
    if (texts.list) {
        writeOutput(listText(cells));
        return kExitSuccess;
    }
    bool stopped = false;
    const std::vector<ExtremeLine> lines = measureCells(cells, stopped);
    if (texts.json) {
        Json object = extremesJson(lines);
        object["scene"] = texts.file.empty() ? Json(nullptr) : Json(texts.file);
        object["complete"] = !stopped;
        writeJson(object);
    } else {
        if (!lines.empty()) writeOutput(extremesText(lines, cells.size()));
    }
    if (stopped) {
        writeError(fmt::format("stopped after {} of {} lines", lines.size(), cells.size()));
        return kExitStopped;
    }
    const bool all =
        std::all_of(lines.begin(), lines.end(), [](const ExtremeLine& line) { return line.holds; });
    return all ? kExitSuccess : kExitFailure;
}

}  // namespace

void addExtremesCommand(CLI::App& app, Action& chosen) {
    const auto texts = std::make_shared<ExtremesTexts>();
    CLI::App* command = app.add_subcommand(
        "extremes", "errors at the edges of what numbers can do, beside a naive program's");
    command->add_option("SCENE", texts->file, "put this scene (TOML) through them, as far as it can be")
        ->type_name("");
    command->add_option("--only", texts->only, "these rows or cells alone, by name: gap, gap:1e-5")
        ->type_name("NAME,...")
        ->delimiter(',');
    command->add_flag("--list", texts->list, "only tell what there is, with the reason for each bound");
    command->add_flag("--json", texts->json, "print one JSON object");
    command->footer(
        "Every line has a known answer. The product's error stands beside its bound, and beside the errors "
        "of "
        "a\nnaive program in float and in double, which keeps rays off their wall by a fixed 0.1 mm.\n"
        "Exit code 1 if a line does not hold.\n\nExamples:\n  halfdisk extremes\n"
        "  halfdisk extremes --only gap,corner\n  halfdisk extremes room.toml --json");
    command->callback([&chosen, texts] { chosen = [texts] { return runExtremes(*texts); }; });
}

}  // namespace halfdisk
