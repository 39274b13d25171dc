// Which pictures of a kind are there, and who made them? One, or two that are compared.
#pragma once

#include <string>
#include <vector>

#include "app/app_state.h"

namespace halfdisk {

/// The estimator's title in the window's language, and what tells it from another one (may be null).
std::string makerTitle(const Maker& maker, const Maker* other);

struct ShownPicture {
    const LightPicture* picture;  ///< has passes
    std::string maker;            ///< the estimator's title, and what tells it from the other one
    bool second = false;          ///< it is the one that the first is compared with
};

/// Of View::eye, field or profile, those that have something to show.
std::vector<ShownPicture> shownPictures(const AppState& state, View view);

}  // namespace halfdisk
