// What happens while the window is open? Frames, and now and then a look at the files on the disk.
#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

#include "app/autosave.h"
#include "app/cli_actions.h"
#include "app/commands.h"
#include "app/export_files.h"
#include "app/file_watch.h"
#include "app/frame.h"
#include "app/language.h"
#include "app/opening.h"
#include "app/recent_files.h"
#include "app/window_host.h"

namespace halfdisk {
int runWindow(const WindowRequest& request) {
    Session session;
    session.state = openRequested(request.opening);
    setRules(session.state, request.rules, !request.opening.shared);

    WindowOptions options;
    options.onDrop = [&](const std::vector<std::filesystem::path>& files) {
        if (!files.empty()) apply(session.state, OpenFile{files.front()});
    };
    std::string whyNot;
    const auto host = WindowHost::open(options, whyNot);
    if (!host) {
        fmt::print(stderr,
                   "halfdisk: no window could be opened: {}\n"
                   "Pictures need no display: halfdisk tour -o DIR, or halfdisk screenshot LESSON:STEP -o "
                   "FILE.png\n",
                   whyNot);
        return kExitFailure;
    }
    speak(findLanguage(session.languages, session.state.language));
    Autosave autosave(stateFolder(), static_cast<long>(getpid()));
    if (const auto left = autosave.recovered(); left && !request.rules.kiosk)
        session.state.banner = say(
            "The program ended with unsaved changes. They are in {}: drop that file on this window, or open "
            "it (Ctrl O).",
            left->string());
    RecentFiles recent(stateFolder());
    if (!request.rules.kiosk) session.state.recent = recent.read();
    if (request.opening.scene) remember(session.state.recent, *request.opening.scene);
    FileWatch watch;
    constexpr int kFramesBetweenLooks = 20;
    int sinceLook = 0;
    const auto show = [&] {
        if (++sinceLook >= kFramesBetweenLooks) {
            sinceLook = 0;
            if (watch.changed(session.state)) apply(session.state, Reload{});
        }
        frame(session, host->fonts(), host->fullScale());
        autosave.look(session.state, ImGui::GetTime());
        recent.look(session.state);
        if (session.state.uiScale != host->uiScale()) host->setUiScale(session.state.uiScale);
    };
    const auto draw = [&](const FrameMaker::Draw& one) { host->frame(one); };
    const FrameMaker maker{draw, draw, [&] { return host->readPixels(); },
                           [&]() -> const Fonts& { return host->fonts(); },
                           [&] { return host->fullScale(); }};
    std::error_code gone;
    const std::filesystem::path here = std::filesystem::current_path(gone);
    host->run(show, [&] { exportIfReady(session, maker, here); });
    return kExitSuccess;
}

}  // namespace halfdisk
