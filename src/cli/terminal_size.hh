#pragma once

namespace pongsim::cli {

/// In letters.
struct TerminalSize {
  int columns = 80;
  int rows = 25;
};

/// @return Of the terminal on stdout; elsewhere that of an old one.
TerminalSize terminalSize();

}  // namespace pongsim::cli
