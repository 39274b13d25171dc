#include "app/csv_text.h"
#include "app/requirements_words.h"

namespace halfdisk {

std::string requirementsTable(const AppState& state) {
    CsvText table({"requirement", "needed", "number", "by", "forced", "reason", "from", "to",
                   "light_change_share", "its_error", "pixels_rms_share", "rays_factor",
                   "time_per_ray_factor", "why_not"});
    const RequirementsAnswer* known = knownRequirements(state);
    if (!known) return table.text();
    const auto& costs = state.answer->instruments.costs;
    const auto result = [&](const PlanCost& cost, const std::string& impossible) {
        if (!impossible.empty()) {
            table.empty(5).cell(std::string_view(impossible));
            return;
        }
        if (const auto& change = cost.change)
            table.cell(change->share).cell(change->standardError).cell(change->ofPixels);
        else
            table.empty(3);
        if (cost.raysFactor)
            table.cell(*cost.raysFactor);
        else
            table.empty();
        table.cell(cost.timePerRayFactor).empty();
    };
    const auto head = [&](const Requirement& one) {
        table.cell(infoOf(one.id).name).cell(one.on ? 1.0 : 0.0);
        if (one.number)
            table.cell(static_cast<double>(*one.number));
        else
            table.empty();
        table.cell(groundWord(one.ground));
        if (const auto value = forcedValue(state.instruments, one.id))
            table.cell(static_cast<double>(*value));
        else
            table.empty();
        table.cell(std::string_view(one.reason));
    };
    for (const Requirement& one : known->requirements) {
        bool any = false;
        if (costs)
            for (const RequirementCost& row : costs->rows) {
                if (row.id != one.id) continue;
                any = true;
                head(one);
                table.cell(static_cast<double>(row.from)).cell(static_cast<double>(row.to));
                result(row.cost, row.impossible);
                table.endRow();
            }
        if (any) continue;
        head(one);
        table.empty(8).endRow();
    }
    if (!costs || !costs->complete()) return table.text();
    table.cell(std::string_view("everything")).empty(7);
    result(costs->everything, costs->everythingImpossible);
    table.endRow();
    return table.text();
}

}  // namespace halfdisk
