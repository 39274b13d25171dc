#include "running_program.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace halfdisk_test {
namespace {

pid_t start(const std::vector<std::string>& arguments, int out, int err) {
    std::vector<std::string> texts{HALFDISK_PROGRAM};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& text : texts) argv.push_back(text.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child > 0) return child;
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
}

int create(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) throw std::runtime_error("cannot open " + path.string());
    return file;
}

int exitCodeOf(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Whether a thread blocks SIGINT, from /proc/PID/task/TID/status.
bool blocksInterrupt(const std::filesystem::path& task) {
    std::ifstream status(task / "status");
    for (std::string word; status >> word;)
        if (word == "SigBlk:") {
            status >> word;
            return (std::stoull(word, nullptr, 16) >> (SIGINT - 1)) & 1u;
        }
    return false;
}

/// Of all its threads, user and system.
double cpuSeconds(const std::filesystem::path& process) {
    const std::string text = readFile(process / "stat");
    const std::size_t name = text.rfind(')');
    if (name == std::string::npos) return 0.0;
    std::istringstream fields(text.substr(name + 1));
    std::string skipped;
    for (int i = 0; i < 11; ++i) fields >> skipped;
    double user = 0.0, system = 0.0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::filesystem::path processFolder(pid_t child) {
    return "/proc/" + std::to_string(child);
}

std::string readUntilClosed(int terminal) {
    std::string text;
    char buffer[4096];
    for (ssize_t count; (count = read(terminal, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(count));
    return text;
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments) {
    const int out = create(folder_ / "out"), err = create(folder_ / "err");
    child_ = start(arguments, out, err);
    close(out);
    close(err);
}

RunningProgram::~RunningProgram() {
    if (hasEnded()) return;
    kill(child_, SIGKILL);
    waitpid(child_, &status_, 0);
}

bool RunningProgram::hasEnded() {
    if (!ended_) ended_ = waitpid(child_, &status_, WNOHANG) == child_;
    return ended_;
}

bool RunningProgram::waitUntilBusy(double seconds) {
    const std::filesystem::path process = processFolder(child_);
    const std::filesystem::path mainThread = process / "task" / std::to_string(child_);
    while (!blocksInterrupt(mainThread)) {
        if (hasEnded()) return false;
        sched_yield();
    }
    const double before = cpuSeconds(process);
    while (cpuSeconds(process) < before + seconds) {
        if (hasEnded()) return false;
        sched_yield();
    }
    return true;
}

void RunningProgram::signal(int number) {
    kill(child_, number);
}

Outcome RunningProgram::waitForEnd() {
    if (!ended_ && waitpid(child_, &status_, 0) != child_) throw std::runtime_error("waitpid failed");
    ended_ = true;
    return {exitCodeOf(status_), readFile(folder_ / "out"), readFile(folder_ / "err")};
}

Outcome runOnTerminal(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0)
        throw std::runtime_error("no terminal is to be had");
    const int err = open(ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC);
    const int out = create(folder / "out");
    const pid_t child = start(arguments, out, err);
    close(out);
    close(err);
    Outcome outcome;
    outcome.err = readUntilClosed(terminal);
    close(terminal);
    int status = 0;
    if (waitpid(child, &status, 0) != child) throw std::runtime_error("waitpid failed");
    outcome.exitCode = exitCodeOf(status);
    outcome.out = readFile(folder / "out");
    return outcome;
}

}  // namespace halfdisk_test
