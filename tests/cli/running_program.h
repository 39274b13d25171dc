// What does the built program do while it runs: to signals, and on a terminal?
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "run_program.h"

namespace halfdisk_test {

/// The program, running. Ended when it goes out of scope.
class RunningProgram {
 public:
    explicit RunningProgram(const std::vector<std::string>& arguments);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    /// Returns when it takes SIGINT in hand itself and has then used so much processor time. False if it
    /// ended before.
    bool waitUntilBusy(double cpuSeconds);

    void signal(int number);
    Outcome waitForEnd();

 private:
    bool hasEnded();

    TemporaryFolder folder_;
    pid_t child_ = -1;
    int status_ = 0;
    bool ended_ = false;
};

/// Runs it with a terminal as stderr; `err` is what the terminal got.
Outcome runOnTerminal(const std::vector<std::string>& arguments);

}  // namespace halfdisk_test
