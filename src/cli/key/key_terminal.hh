#pragma once

#include <termios.h>

namespace pongsim::cli {

/// Makes a terminal send each key immediately and without echo, for the lifetime of this object. Ctrl-C still
/// interrupts; Ctrl-Z and Ctrl-\ don't, because they would leave the terminal in this mode. Does nothing without a
/// terminal.
class KeyTerminal {
 public:
  explicit KeyTerminal(int descriptor);
  ~KeyTerminal();
  KeyTerminal(const KeyTerminal&) = delete;
  KeyTerminal& operator=(const KeyTerminal&) = delete;

  bool isTerminal() const { return isTerminal_; }

 private:
  int descriptor_;
  termios before_{};
  bool isTerminal_;
};

}  // namespace pongsim::cli
