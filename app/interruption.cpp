// Was the program asked to stop, and how does it learn of it without leaving work half done?
//
// The signals are blocked and read from a descriptor, so that no handler and no global is needed.
#include "app/interruption.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

namespace halfdisk {
namespace {

bool isIgnored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

Interruption::Interruption(std::function<void()> onFirst) : onFirst_(std::move(onFirst)) {
    sigemptyset(&watched_);
    for (const int signal : {SIGINT, SIGTERM})
        if (!isIgnored(signal)) sigaddset(&watched_, signal);
    signals_ = signalfd(-1, &watched_, SFD_CLOEXEC);
    end_ = eventfd(0, EFD_CLOEXEC);
    if (signals_ < 0 || end_ < 0) throw std::system_error(errno, std::generic_category(), "signals");
    pthread_sigmask(SIG_BLOCK, &watched_, &maskBefore_);
    watcher_ = std::thread([this] { watch(); });
}

Interruption::~Interruption() {
    const std::uint64_t one = 1;
    while (write(end_, &one, sizeof one) < 0 && errno == EINTR) {
    }
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &maskBefore_, nullptr);
    close(signals_);
    close(end_);
}

void Interruption::watch() {
    pollfd sources[] = {{end_, POLLIN, 0}, {signals_, POLLIN, 0}};
    while (poll(sources, 2, -1) < 0 && errno == EINTR) {
    }
    if (sources[0].revents != 0) return;
    signalfd_siginfo signal;
    if (read(signals_, &signal, sizeof signal) != sizeof signal) return;
    asked_ = true;
    if (onFirst_) onFirst_();
    // From here on this thread takes the signals, and they end the program.
    pthread_sigmask(SIG_UNBLOCK, &watched_, nullptr);
    while (poll(sources, 1, -1) < 0 && errno == EINTR) {
    }
}

}  // namespace halfdisk
