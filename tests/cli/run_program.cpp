#include "run_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace halfdisk_test {
namespace {

/// In the child, where nothing may be thrown.
void replaceProcess(std::vector<char*> argv, int in, int out, int err) {
    if (in >= 0) dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    execv(argv[0], argv.data());
    _exit(127);
}

int waitForExit(pid_t child) {
    int status = 0;
    if (waitpid(child, &status, 0) != child) throw std::runtime_error("waitpid failed");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int openForWriting(const std::filesystem::path& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) throw std::runtime_error("cannot open " + path.string());
    return file;
}

/// `in` below 0: what this program has.
Outcome run(int out, const std::filesystem::path& errPath, const std::vector<std::string>& arguments,
            int in = -1) {
    const int err = openForWriting(errPath);
    std::vector<std::string> texts{HALFDISK_PROGRAM};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& text : texts) argv.push_back(text.data());
    argv.push_back(nullptr);

    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) replaceProcess(argv, in, out, err);
    close(out);
    close(err);
    Outcome outcome;
    outcome.exitCode = waitForExit(child);
    outcome.err = readFile(errPath);
    return outcome;
}

int closedPipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("pipe failed");
    close(ends[0]);
    return ends[1];
}

}  // namespace

Outcome runProgram(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    Outcome outcome = run(openForWriting(folder / "out"), folder / "err", arguments);
    outcome.out = readFile(folder / "out");
    return outcome;
}

Outcome runProgramFrom(const std::string& input, const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const int in = open(input.c_str(), O_RDONLY | O_CLOEXEC);
    if (in < 0) throw std::runtime_error("cannot open " + input);
    Outcome outcome = run(openForWriting(folder / "out"), folder / "err", arguments, in);
    close(in);
    outcome.out = readFile(folder / "out");
    return outcome;
}

Outcome runProgramInto(const std::string& device, const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    return run(device.empty() ? closedPipe() : openForWriting(device), folder / "err", arguments);
}

std::string sceneFile(const std::string& name) {
    return std::string(HALFDISK_CLI_SCENES) + "/" + name;
}

std::string shippedScene(const std::string& name) {
    return std::string(HALFDISK_SHIPPED_SCENES) + "/" + name;
}

std::string readFile(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "halfdisk-cli-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("mkdtemp failed");
    path = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

}  // namespace halfdisk_test
