// By which way did light come that a step of a recorded run found? Its word: L, every wall from the light on
// (D diffuse or glossy, S mirror or glass), E.
#pragma once

#include <string>

#include "path_recorder.h"

namespace halfdisk {

/// Is told all events of a run in their order. Not of photons that are looked up: those came by many ways.
class PathWord {
 public:
    /// Of what this event adds; empty if it adds nothing.
    std::string of(const PathEvent& event);

    /// The walls of the sensor's path, or of the light's if there is none, as far as it came; in the order in
    /// which light would pass them.
    std::string walls() const;

 private:
    void follow(const PathEvent& event);

    std::string sensor_, light_;  // a letter for each wall that was met, from the path's start on
};

}  // namespace halfdisk
