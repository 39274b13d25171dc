// With what is a scene changed? Tools, what is selected (inspector.cpp), and where the scene goes.
#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/edit_commands.h"
#include "app/imgui_compat.h"
#include "app/key_help.h"
#include "app/key_words.h"
#include "app/message_words.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

void tools(const Ui& ui) {
    const float width = partOfRow(3);
    int column = 0;
    for (const Named<Tool>& tool : kTools) {
        if (column % 3 != 0) sameLineIfFits(tool.name, width);
        ++column;
        bool on = ui.state.editing.tool == tool.value;
        if (toggle(ui.widgets, std::string(tool.name).c_str(), on, {width, 0}))
            ui.commands.push_back(SetTool{tool.value});
        tooltip(tool.meaning);
    }
}

void historyButtons(const Ui& ui) {
    const History& history = ui.state.editing.history;
    const float width = partOfRow(3);
    const auto choice = [&](const char* label, bool there, const Command& command,
                            const std::string& meaning) {
        ImGui::BeginDisabled(!there);
        if (button(ui.widgets, label, {width, 0})) ui.commands.push_back(command);
        tooltip(meaning);
        ImGui::EndDisabled();
    };
    choice("Undo", !history.past.empty(), Undo{},
           withKey("take the last change back", keyOf(KeyRow::history)));
    sameLineIfFits("Redo", width);
    choice("Redo", !history.future.empty(), Redo{}, withKey("and make it again", keyOf(KeyRow::history, 1)));
    sameLineIfFits("Snap", width);
    bool snap = ui.state.editing.snap;
    if (toggle(ui.widgets, "Snap", snap, {width, 0})) ui.commands.push_back(SetSnap{snap});
    tooltip("to the ends of things and to a grid; Alt: not now; Shift: angles of 15 degrees");
}

void saving(const Ui& ui) {
    const Editing& editing = ui.state.editing;
    std::string path = editing.path;
    if (inputText(ui.widgets, "file", path)) ui.commands.push_back(SetScenePath{path});
    tooltip(
        "where the scene is saved; a name that ends with .toml. Another file that is there already is "
        "written over only when you save twice.");
    const float half = partOfRow(2);
    if (button(ui.widgets, isEdited(ui.state) ? "Save*" : "Save", {half, 0}))
        ui.commands.push_back(SaveScene{editing.path});
    tooltip(withKey("write the scene file", keyOf(KeyRow::files)));
    sameLineIfFits("Open ...", half);
    if (button(ui.widgets, "Open ...", {half, 0})) ui.commands.push_back(ShowFiles{true});
    tooltip(withKey("a lesson or a scene; the last files come first", keyOf(KeyRow::files, 1)));
    if (button(ui.widgets, "Done", {partOfRow(1), 0})) ui.commands.push_back(SetEditing{false});
    tooltip("back to the lesson, in the changed scene; Reset brings the lesson's own back");
    if (!editing.message.empty()) textWrapped(ui.widgets, trMessage(editing.message));
}

}  // namespace

void editPanel(const Ui& ui) {
    const Editing& editing = ui.state.editing;
    // What was held in the inspector is held no more.
    if (editing.start && ui.state.grip == Grip::none && !ImGui::IsAnyItemActive() && !anyArrowDown())
        ui.commands.push_back(SetGrip{Grip::none});
    tools(ui);
    historyButtons(ui);
    const float labels = textSize("thickness").x + 2 * ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::PushItemWidth(std::max(ImGui::GetContentRegionAvail().x - labels, 60 * ui.scale));
    ImGui::Separator();
    inspector(ui);
    ImGui::Separator();
    saving(ui);
    ImGui::PopItemWidth();
}

}  // namespace halfdisk
