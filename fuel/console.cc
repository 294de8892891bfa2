#include "fuel/console.hh"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace pongsim::fuel {

void sayError(const std::string& message, const std::string& hint) {
  const std::string text = "pongsim: error: " + message + (hint.empty() ? "" : "\n  hint: " + hint) + "\n";
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  if (errno != EPIPE) throw Failure(std::string("cannot write to stdout: ") + std::strerror(errno));
}

bool outputHasColors() {
  const char* forbidden = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool isForbidden = forbidden != nullptr && *forbidden != '\0';
  return !isForbidden && terminal != nullptr && std::string_view(terminal) != "dumb" && isatty(STDOUT_FILENO) == 1;
}

}  // namespace pongsim::fuel
