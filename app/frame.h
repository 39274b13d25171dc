// What happens in one frame? Read the light's newest answer, draw every panel, apply what they ask for. Both
// hosts call it.
#pragma once

#include "app/app_state.h"
#include "app/commands.h"
#include "app/fonts.h"
#include "app/language.h"
#include "app/light_job.h"
#include "app/source_listing.h"
#include "app/theme.h"
#include "app/widgets.h"

namespace halfdisk {

struct Sheet;

/// Everything that a panel may read, and where it puts its commands.
struct Ui {
    const AppState& state;
    const Fonts& fonts;
    const Palette& palette;
    const Listings& listings;
    WidgetRegistry& widgets;
    Commands& commands;
    const std::vector<Language>& languages;
    float scale;             ///< pixels per design pixel
    Sheet* sheet = nullptr;  ///< where canvas and plots are recorded; null: nowhere
};

/// The running program.
struct Session {
    AppState state;
    Listings listings = loadListings();
    std::vector<Language> languages = loadLanguages();
    Palette palette;
    WidgetRegistry widgets;
    LightJob light;
    std::uint64_t asked = 0;  ///< the last question put to the light
    double effort = 1.0;      ///< LightQuestion::effort of what is asked
};

/// Between ImGui's NewFrame and Render. Never waits and never reads the clock: time is ImGui's DeltaTime.
/// `sheet`, if not null, gets what canvas and plots draw.
void frame(Session& session, const Fonts& fonts, float uiScale, Sheet* sheet = nullptr);

/// Asks the light for the state's question if that changed.
void askLight(Session& session);

}  // namespace halfdisk
