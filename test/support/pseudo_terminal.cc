#include "support/pseudo_terminal.hh"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <stdexcept>

namespace pongsim::test {

std::unique_ptr<PseudoTerminal> PseudoTerminal::open() {
  std::unique_ptr<PseudoTerminal> result(new PseudoTerminal);
  result->control_ = posix_openpt(O_RDWR | O_NOCTTY);
  if (result->control_ < 0 || grantpt(result->control_) != 0 || unlockpt(result->control_) != 0) return nullptr;
  const char* const name = ptsname(result->control_);
  if (name == nullptr) return nullptr;
  result->name_ = name;
  result->terminal_ = ::open(name, O_RDWR | O_NOCTTY);
  return result->terminal_ < 0 ? nullptr : std::move(result);
}

PseudoTerminal::~PseudoTerminal() {
  if (terminal_ >= 0) close(terminal_);
  if (control_ >= 0) close(control_);
}

void PseudoTerminal::type(std::string_view keys) const {
  if (write(control_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    throw std::runtime_error("the terminal does not take keys");
  }
}

void PseudoTerminal::waitFor(std::string_view text) const {
  constexpr int kPatienceMs = 60'000;
  std::string shown;
  while (shown.find(text) == std::string::npos) {
    pollfd descriptor{control_, POLLIN, 0};
    char bytes[64];
    const ssize_t count = poll(&descriptor, 1, kPatienceMs) > 0 ? read(control_, bytes, sizeof bytes) : 0;
    if (count <= 0) throw std::runtime_error("the terminal was not told what it was to be");
    shown.append(bytes, static_cast<std::size_t>(count));
  }
}

termios PseudoTerminal::settings() const {
  termios now{};
  if (tcgetattr(terminal_, &now) != 0) throw std::runtime_error("the terminal does not tell its settings");
  return now;
}

}  // namespace pongsim::test
