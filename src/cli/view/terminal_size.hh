#pragma once

namespace pongsim::cli {

struct TerminalSize {
  /// In characters.
  int columns = 80;
  int rows = 25;
  /// Size of a character [pixels]; if the terminal does not tell, a typical size.
  int letterWidth = 10;
  int letterHeight = 20;
};

/// @return The size of the terminal on stdout; without one, the defaults.
TerminalSize terminalSize();

}  // namespace pongsim::cli
