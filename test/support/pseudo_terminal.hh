#pragma once

#include <termios.h>

#include <memory>
#include <string>
#include <string_view>

namespace pongsim::test {

/// A terminal whose keyboard the test is.
class PseudoTerminal {
 public:
  /// @return A new one; null on a machine that has none (skip the test then).
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
  /// Waits until that was written to the terminal.
  /// @throws std::runtime_error if it was not in time.
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
