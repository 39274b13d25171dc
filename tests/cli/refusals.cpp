#include "refusals.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "run_program.h"

namespace halfdisk_test {

void checkRefused(const std::vector<std::string>& arguments, const std::string& message) {
    std::string command;
    for (const std::string& argument : arguments) command += " " + argument;
    CAPTURE(command);
    const Outcome outcome = runProgram(arguments);
    CHECK(outcome.exitCode == 2);
    CHECK(outcome.out == "");
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_MESSAGE(outcome.err.find(message) != std::string::npos, outcome.err);
}

}  // namespace halfdisk_test
