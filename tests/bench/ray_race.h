// How fast are rays answered in one scene, by Halfdisk and by its peers, and are the answers right?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benches.h"
#include "peers.h"
#include "required.h"

namespace halfdisk {

/// How a contender did.
struct Lap {
    std::string who;
    double seconds = 0.0;         ///< CPU time per ray, median
    std::size_t differences = 0;  ///< of its answers from the brute check's
};

/// One kind of question in one scene.
struct Race {
    const QueryInfo* query = nullptr;
    std::size_t size = 0;      ///< as asked for
    std::size_t segments = 0;  ///< as made
    std::string method;        ///< that IndexMethod::automatic takes
    std::vector<Lap> laps;     ///< Halfdisk's own choice first
    std::size_t checked = 0;   ///< rays whose answers were compared
    std::string embree;        ///< the fastest of Embree's ways that counts; empty: not installed
    double overEmbree = 0.0;   ///< median ratio of interleaved runs; 0: not measured
    double overBox2D = 0.0;
};

/// All kinds of questions.
std::vector<Race> raceRays(Pattern pattern, std::size_t size, Effort effort);

}  // namespace halfdisk
