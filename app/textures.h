// Which pictures do the draw lists of a frame refer to? They are kept until no frame shows them.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/imgui_compat.h"
#include "app/png_image.h"

namespace halfdisk {

/// Of one Dear ImGui context. What becomes of them in OpenGL is the renderer's business.
class Textures {
 public:
    struct Entry {
        unsigned name;                         ///< never given again
        std::shared_ptr<const Image> picture;  ///< premultiplied
        bool shown;                            ///< since the frame began
    };

    /// What the frame before did not show is forgotten.
    void beginFrame() {
        std::erase_if(entries_, [](const Entry& entry) { return !entry.shown; });
        for (Entry& entry : entries_) entry.shown = false;
    }

    /// To draw this picture in this frame.
    ImTextureID idOf(const std::shared_ptr<const Image>& picture) {
        auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.picture == picture; });
        if (found == entries_.end()) found = entries_.insert(found, {next_++, picture, true});
        found->shown = true;
        return textureId(found->name);
    }

    const std::vector<Entry>& entries() const { return entries_; }

 private:
    /// Far above the names that OpenGL gives.
    static constexpr unsigned kFirst = 1u << 30;
    std::vector<Entry> entries_;
    unsigned next_ = kFirst;
};

/// Of the current context; null if it has none.
inline Textures* currentTextures() {
    return static_cast<Textures*>(ImGui::GetIO().UserData);
}

}  // namespace halfdisk
