// What does the built program print, and how does it end?
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace halfdisk_test {

struct Outcome {
    int exitCode = 0;  ///< 128 + n if signal n ended it
    std::string out, err;
};

/// Runs the program with these arguments, without a display, and waits for its end.
Outcome runProgram(const std::vector<std::string>& arguments);

/// The same with the file as standard input.
Outcome runProgramFrom(const std::string& input, const std::vector<std::string>& arguments);

/// The same with stdout going to `device`, or to a closed pipe if it is empty.
Outcome runProgramInto(const std::string& device, const std::vector<std::string>& arguments);

/// Path of a file in tests/cli/scenes.
std::string sceneFile(const std::string& name);

/// Path of a scene file that comes with the lessons.
std::string shippedScene(const std::string& name);

std::string readFile(const std::filesystem::path& path);

/// A new empty folder, removed at the end.
class TemporaryFolder {
 public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path / name; }

    std::filesystem::path path;
};

}  // namespace halfdisk_test
