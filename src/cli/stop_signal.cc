#include "cli/stop_signal.hh"

#include <poll.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace pongsim::cli {

StopSignal::StopSignal() {
  sigset_t wanted;
  sigemptyset(&wanted);
  sigaddset(&wanted, SIGINT);
  sigaddset(&wanted, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &wanted, nullptr);
  signals_ = signalfd(-1, &wanted, SFD_CLOEXEC);
  end_ = eventfd(0, EFD_CLOEXEC);
  if (signals_ < 0 || end_ < 0) throw std::runtime_error("no file descriptors left");
  thread_ = std::thread([this] { watch(); });
}

StopSignal::~StopSignal() {
  eventfd_write(end_, 1);
  thread_.join();
  close(signals_);
  close(end_);
}

StopSignal::Callback::Callback(StopSignal& signal, std::function<void()> notify) : signal_(signal) {
  const std::lock_guard lock(signal.mutex_);
  signal.notify_ = std::move(notify);
  if (signal.stopped_) signal.notify_();
}

StopSignal::Callback::~Callback() {
  const std::lock_guard lock(signal_.mutex_);
  signal_.notify_ = nullptr;
}

void StopSignal::watch() {
  std::array<pollfd, 2> watched{{{signals_, POLLIN, 0}, {end_, POLLIN, 0}}};
  while (true) {
    if (poll(watched.data(), watched.size(), -1) < 0) continue;
    if (watched[1].revents != 0) return;
    signalfd_siginfo signal{};
    if (read(signals_, &signal, sizeof signal) != static_cast<ssize_t>(sizeof signal)) continue;
    if (stopped_) std::_Exit(128 + static_cast<int>(signal.ssi_signo));
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    if (notify_) notify_();
  }
}

}  // namespace pongsim::cli
