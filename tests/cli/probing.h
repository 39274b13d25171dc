// What does `halfdisk probe` answer?
#pragma once

#include <string>
#include <vector>

#include "result_files.h"
#include "run_program.h"

namespace halfdisk_test {

/// Most that a mean may be off by. Seeds are fixed, and comparisons few: a right program fails one of them
/// with probability 5e-4.
inline constexpr double kMostStandardErrors = 3.5;

/// Runs the program on a scene of tests/cli/scenes.
Outcome probe(const std::string& scene, std::vector<std::string> arguments);

/// The object that it prints with --json. Fails the test if it is none.
Json probeJson(const std::string& scene, std::vector<std::string> arguments);

}  // namespace halfdisk_test
