// halfdisk estimators: which ways to carry light are there, what can each do, and what can be set?
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/cli_actions.h"
#include "app/cli_commands.h"
#include "app/cli_output.h"
#include "app/estimator_table.h"
#include "lessons/scene_file.h"

namespace halfdisk {
namespace {

int runEstimators(const std::string& file, bool asJson) {
    std::vector<EstimatorRow> rows;
    if (file.empty()) {
        rows = estimatorRows(sceneOfEverything(), false);
    } else {
        rows = estimatorRows(expandScene(loadScene(file)), true);
    }
    if (asJson) {
        writeJson(Json{{"scene", file.empty() ? Json(nullptr) : Json(file)}, {"estimators", rowsJson(rows)}});
    } else {
        writeOutput(rowsText(rows, file));
    }
    return kExitSuccess;
}

}  // namespace

void addEstimatorsCommand(CLI::App& app, Action& chosen) {
    struct Texts {
        std::string file;
        bool json = false;
    };
    const auto texts = std::make_shared<Texts>();
    CLI::App* command =
        app.add_subcommand("estimators", "list the ways to carry light: sensors, paths, bias, parameters");
    command->add_option("SCENE", texts->file, "tell what they can do in this scene")->type_name("");
    command->add_flag("--json", texts->json, "print one JSON object");
    command->footer(
        "Paths are regular expressions over L (light), D (a matt or glossy wall), S (a mirror or glass) and "
        "E "
        "(the sensor).\n\nExamples:\n  halfdisk estimators\n  halfdisk estimators room.toml --json");
    command->callback(
        [&chosen, texts] { chosen = [texts] { return runEstimators(texts->file, texts->json); }; });
}

}  // namespace halfdisk
