// Which pictures do the draw lists of a frame refer to? They are kept until no frame shows them.
#pragma once

#include <imgui.h>

#include <memory>
#include <vector>

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
    void beginFrame();

    /// To draw this picture in this frame.
    ImTextureID idOf(const std::shared_ptr<const Image>& picture);

    const std::vector<Entry>& entries() const { return entries_; }

 private:
    /// Far above the names that OpenGL gives.
    static constexpr unsigned kFirst = 1u << 30;
    std::vector<Entry> entries_;
    unsigned next_ = kFirst;
};

/// Of the current context; null if it has none.
Textures* currentTextures();

}  // namespace halfdisk
