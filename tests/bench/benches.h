// What is measured? Each prints its own table.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace halfdisk {

/// Short runs only show that the benchmark works.
enum class Effort { quick, full };

/// The scenes of the course's lessons: file by name.
std::map<std::string, std::filesystem::path> lessonScenes();

/// CPU time of the frame function, the light's thread and the software GL left out, while P is dragged along
/// the walls of each lesson's scene with N = 64 and maxDepth = 2. Required: less than 8 ms in each frame.
void benchFrame(Effort effort);

/// castRay with NoObserver against the same source without its observer, in turns within one process.
/// Required: a ratio below 1.02. And the cost of a ray on each lesson's scene.
void benchRays(Effort effort);

}  // namespace halfdisk
