// What has been drawn in a frame, so that it can be written to files? One drawing for the canvas, one for
// each plot and strip.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "app/frame.h"
#include "app/svg_drawing.h"

namespace halfdisk {

/// Where a frame draws to besides the screen.
struct Sheet {
    std::vector<SvgDrawing> drawings;  ///< complete, each name once
    std::optional<SvgDrawing> open;    ///< what is being drawn

    const SvgDrawing* find(std::string_view name) const {
        const auto found = std::find_if(drawings.begin(), drawings.end(),
                                        [&](const SvgDrawing& drawing) { return drawing.name() == name; });
        return found == drawings.end() ? nullptr : &*found;
    }
};

/// While it lives, all that the pen draws belongs to this drawing (pixels of the screen). Does nothing
/// without a sheet, and where the sheet has the drawing already.
class OnSheet {
 public:
    OnSheet(const Ui& ui, std::string_view name, ImVec2 min, ImVec2 max) : sheet_(ui.sheet) {
        if (!sheet_ || sheet_->open || sheet_->find(name)) {
            sheet_ = nullptr;
            return;
        }
        sheet_->open.emplace(std::string(name), min, max, ui.palette.background);
    }
    /// From where the next item of the window goes, with a margin.
    OnSheet(const Ui& ui, std::string_view name, ImVec2 size)
        : OnSheet(ui, name, withMargin(ui, {0.0f, 0.0f}, -1.0f), withMargin(ui, size, 1.0f)) {}
    ~OnSheet() { end(); }
    OnSheet(const OnSheet&) = delete;
    OnSheet& operator=(const OnSheet&) = delete;

    void end() {
        if (!sheet_) return;
        sheet_->drawings.push_back(std::move(*sheet_->open));
        sheet_->open.reset();
        sheet_ = nullptr;
    }

 private:
    static constexpr float kMargin = 8;  // design pixels
    static ImVec2 withMargin(const Ui& ui, ImVec2 offset, float sign) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float margin = sign * kMargin * ui.scale;
        return {at.x + offset.x + margin, at.y + offset.y + margin};
    }

    Sheet* sheet_;
};

}  // namespace halfdisk
