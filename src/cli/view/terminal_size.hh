#pragma once

namespace pongsim::cli {

struct TerminalSize {
  /// In letters.
  int columns = 80;
  int rows = 25;
  /// Of a letter [pixels]; those of an old terminal, where it does not tell.
  int letterWidth = 10;
  int letterHeight = 20;
};

/// @return Of the terminal on stdout; elsewhere that of an old one.
TerminalSize terminalSize();

}  // namespace pongsim::cli
