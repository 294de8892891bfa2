#include "cli/terminal_size.hh"

#include <sys/ioctl.h>
#include <unistd.h>

namespace pongsim::cli {

TerminalSize terminalSize() {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0 || window.ws_row == 0) return {};
  return {window.ws_col, window.ws_row};
}

}  // namespace pongsim::cli
