#include "shared/program/console.hh"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// A single write, so that lines of several processes do not mix.
void writeError(std::string text) {
  text += '\n';
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace

void sayError(std::string_view message, std::string_view hint) {
  std::string text = "pongsim: error: " + std::string(message);
  if (!hint.empty()) text += "\n  hint: " + std::string(hint);
  writeError(std::move(text));
}

int fail(std::string_view message, std::string_view hint) {
  sayError(message, hint);
  return kFailed;
}

void say(std::string_view message) { writeError("pongsim: " + std::string(message)); }

bool print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return true;
  if (errno != EPIPE) throw Failure(std::string("can't write to stdout: ") + std::strerror(errno));
  return false;
}

bool outputIsClosed() {
  pollfd output{STDOUT_FILENO, 0, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLNVAL)) != 0;
}

bool hasColors(int file) {
  const char* forbidden = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool isForbidden = forbidden != nullptr && *forbidden != '\0';
  return !isForbidden && terminal != nullptr && std::string_view(terminal) != "dumb" && isatty(file) == 1;
}

}  // namespace pongsim::cli
