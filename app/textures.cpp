#include "app/textures.h"

#include <algorithm>

#include "app/imgui_compat.h"

namespace halfdisk {

void Textures::beginFrame() {
    std::erase_if(entries_, [](const Entry& entry) { return !entry.shown; });
    for (Entry& entry : entries_) entry.shown = false;
}

ImTextureID Textures::idOf(const std::shared_ptr<const Image>& picture) {
    auto found = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& entry) { return entry.picture == picture; });
    if (found == entries_.end()) found = entries_.insert(found, {next_++, picture, true});
    found->shown = true;
    return textureId(found->name);
}

Textures* currentTextures() {
    return static_cast<Textures*>(ImGui::GetIO().BackendRendererUserData);
}

}  // namespace halfdisk
