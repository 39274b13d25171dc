// Which walls did one end's path meet? What bidirectional tracing keeps of a walk.
#pragma once

#include "core/path_densities.h"
#include "core/walk.h"

namespace halfdisk {

/// One end's walk: the walls that it met, with what it carries on arriving there.
struct Subpath {
    struct Vertex {
        InnerVertex wall;
        Rgb throughput{0.0};
        std::uint32_t scatterings = 0;  ///< before this wall
        double u = 0.0;                 ///< on its segment
    };
    std::vector<Vertex> vertices;
    Ray escaped;  ///< into the environment, with this throughput; none: black
    Rgb escapedThroughput{0.0};
    std::uint32_t escapedScatterings = 0;

    /// For the next walk; keeps the memory.
    void clear() {
        vertices.clear();
        escapedThroughput = Rgb(0.0);
    }
};

struct SubpathVisitor : WalkVisitor {
    Subpath& path;
    explicit SubpathVisitor(Subpath& kept) : path(kept) {}

    bool arrive(const Arrival& here) {
        path.vertices.push_back({{here.at, false}, here.throughput, here.scatterings, here.hit.u});
        return true;
    }
    void depart(const Arrival&, const Scattered& way) { path.vertices.back().wall.delta = way.isDelta(); }
    void escape(const Ray& ray, const Rgb& throughput, std::uint32_t scatterings) {
        path.escaped = ray;
        path.escapedThroughput = throughput;
        path.escapedScatterings = scatterings;
    }
};

}  // namespace halfdisk
