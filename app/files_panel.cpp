// Which lesson or scene shall be opened? A path, and the list of what is in its folder; the last files first.
#include "app/draw_text.h"
#include "app/edit_commands.h"
#include "app/message_words.h"
#include "app/overlay.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

/// What a path that is typed becomes by a choice.
std::string completed(const FileChoice& choice) {
    return choice.isFolder ? (choice.path / "").string() : choice.path.string();
}

Command chosen(const FileChoice& choice) {
    if (choice.isFolder) return SetFilePath{completed(choice)};
    return OpenFile{choice.path};
}

/// What the right end of the row tells.
std::string_view remark(const FileChoice& choice) {
    if (choice.isMissing) return "missing";
    return choice.isRecent ? "lately" : choice.isFolder ? "folder" : "";
}

bool row(const Ui& ui, const FileChoice& choice, bool selected, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), padding = ImGui::GetStyle().FramePadding;
    const bool clicked = listRow(ui, choice.name, selected, width);
    const std::string_view words = remark(choice);
    const float right = words.empty() ? 0.0f : textSize(words).x + 3 * padding.x;
    drawText(ui, {at.x + padding.x, at.y + padding.y}, choice.isMissing ? ui.palette.inkSoft : ui.palette.ink,
             firstThatFits({choice.name, choice.path.filename().string()}, width - 2 * padding.x - right));
    drawText(ui, {at.x + width - padding.x, at.y + padding.y}, ui.palette.inkSoft, words, Align::right);
    return clicked;
}

}  // namespace

void filesOverlay(const Ui& ui) {
    const FileChooser& files = ui.state.files;
    const std::vector<FileChoice> choices = choicesOf(files);
    const bool failed = !ui.state.banner.empty();
    const std::string banner = trMessage(ui.state.banner);
    const ListOverlay overlay = beginListOverlay(
        ui, {"Files", "a lesson or a scene: a file that ends with .toml", files.path, files.selected,
             choices.size(),
             failed ? std::string_view(banner) : "Enter: open   Tab: take the name   Escape: close"});
    if (overlay.typed) ui.commands.push_back(SetFilePath{*overlay.typed});
    if (failed && (overlay.typed || overlay.closed)) ui.commands.push_back(DismissBanner{});
    if (overlay.selected != files.selected) ui.commands.push_back(SelectFile{overlay.selected});
    std::optional<Command> wanted;
    for (std::size_t i = overlay.first; i < overlay.last; ++i)
        if (row(ui, choices[i], i == overlay.selected, overlay.width)) wanted = chosen(choices[i]);
    if (choices.empty()) text(ui.widgets, "nothing there that could be opened");
    endListOverlay(ui, overlay);
    const bool there = overlay.selected < choices.size();
    if (overlay.closed) wanted = ShowFiles{false};
    if (overlay.entered) wanted = there ? chosen(choices[overlay.selected]) : Command(OpenFile{files.path});
    if (overlay.completed && there) wanted = SetFilePath{completed(choices[overlay.selected])};
    if (!wanted) return;
    ui.commands.push_back(*wanted);
    refillField();
}

}  // namespace halfdisk
