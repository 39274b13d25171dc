// How does a test export without OpenGL? All but the screen's pixels, for which a dot stands.
#pragma once

#include <string>

#include "app/export_files.h"
#include "rig.h"

namespace halfdisk {

inline FrameMaker makerOf(Rig& rig) {
    const auto layOut = [&rig](const FrameMaker::Draw& draw) { rig.host->frameWithoutDrawing(draw); };
    return {layOut, layOut,
            [] {
                return Image{1, 1, {0, 0, 0, 255}};
            },
            [&rig]() -> const Fonts& { return rig.host->fonts(); }, [&rig] { return rig.host->uiScale(); }};
}

inline std::vector<ExportFile> exported(Rig& rig) {
    return exportFiles(rig.state(), seenBy(rig.session, makerOf(rig)));
}

/// Null if there is none.
inline const std::string* fileOf(const std::vector<ExportFile>& files, std::string_view name) {
    for (const ExportFile& file : files)
        if (file.name == name) return &file.bytes;
    return nullptr;
}

}  // namespace halfdisk
