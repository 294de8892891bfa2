#pragma once

#include <termios.h>

namespace pongsim::cli {

/// Makes a terminal send each key at once and unseen, for as long as this lives. Ctrl-C goes on to interrupt; Ctrl-Z
/// and Ctrl-\ do not, for they would leave the terminal so. Does nothing where there is no terminal.
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
