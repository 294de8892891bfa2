#include "cli/key/key_terminal.hh"

#include <unistd.h>

namespace pongsim::cli {

KeyTerminal::KeyTerminal(int descriptor) : descriptor_(descriptor), isTerminal_(tcgetattr(descriptor, &before_) == 0) {
  if (!isTerminal_) return;
  termios keys = before_;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_cc[VMIN] = 1;
  keys.c_cc[VTIME] = 0;
  keys.c_cc[VSUSP] = _POSIX_VDISABLE;
  keys.c_cc[VQUIT] = _POSIX_VDISABLE;
  tcsetattr(descriptor_, TCSANOW, &keys);
}

KeyTerminal::~KeyTerminal() {
  if (isTerminal_) tcsetattr(descriptor_, TCSANOW, &before_);
}

}  // namespace pongsim::cli
