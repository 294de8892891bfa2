#include "cli/view/terminal_size.hh"

#include <sys/ioctl.h>
#include <unistd.h>

namespace pongsim::cli {

TerminalSize terminalSize() {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0 || window.ws_row == 0) return {};
  TerminalSize size{window.ws_col, window.ws_row};
  if (window.ws_xpixel >= window.ws_col && window.ws_ypixel >= window.ws_row) {
    size.letterWidth = window.ws_xpixel / window.ws_col;
    size.letterHeight = window.ws_ypixel / window.ws_row;
  }
  return size;
}

}  // namespace pongsim::cli
