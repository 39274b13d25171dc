// What is a list of all that can be done made of? Parts that look at one side of the state each.
#pragma once

#include <utility>

#include "app/doable.h"
#include "app/language.h"

namespace halfdisk {

/// Adds what may be done to a list.
struct Offer {
    const AppState& state;
    std::vector<Doable> all;

    void add(const std::string& name, std::string_view key, Command command) {
        if (!isForbidden(state, command)) all.push_back({std::string(tr(name)), key, std::move(command)});
    }
    void addIf(bool there, const std::string& name, std::string_view key, Command command) {
        if (there) add(name, key, std::move(command));
    }
};

void offerEditing(Offer& offer);
/// N, depth, seed, sampler, emitters, defects.
void offerSettings(Offer& offer);
void offerViews(Offer& offer);
void offerEstimators(Offer& offer);
/// Of the eye's strip, to be looked into; and the order of the list of what was seen.
void offerPixels(Offer& offer);

}  // namespace halfdisk
