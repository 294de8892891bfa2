#pragma once

#include <termios.h>

#include <memory>
#include <string>
#include <string_view>

namespace pongsim::test {

/// A terminal on which the test types.
class PseudoTerminal {
 public:
  /// @return A new one; null if the machine has no pseudo-terminals (skip the test then).
  static std::unique_ptr<PseudoTerminal> open();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// @return Path of its device.
  const std::string& name() const { return name_; }
  /// @return File descriptor of the terminal itself.
  int terminal() const { return terminal_; }
  /// @throws std::runtime_error if the keys can't be sent.
  void type(std::string_view keys) const;
  /// Waits until a program has written this text to the terminal.
  /// @throws std::runtime_error after `kDeadline`.
  void waitFor(std::string_view text) const;
  /// @throws std::runtime_error if they can't be read.
  termios settings() const;

 private:
  PseudoTerminal() = default;
  int control_ = -1;
  int terminal_ = -1;
  std::string name_;
};

}  // namespace pongsim::test
