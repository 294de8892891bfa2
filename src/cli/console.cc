#include "cli/console.hh"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace pongsim::cli {

namespace {

/// In one write, so that lines of several processes do not mix.
void writeError(std::string text) {
  text += '\n';
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace

UsageError::UsageError(const std::string& message, std::string hint)
    : std::runtime_error(message), hint_(std::move(hint)) {}

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

bool errorsHaveColors() {
  const char* forbidden = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool isForbidden = forbidden != nullptr && *forbidden != '\0';
  return !isForbidden && terminal != nullptr && std::string_view(terminal) != "dumb" && isatty(STDERR_FILENO) == 1;
}

bool print(std::string_view data) {
  errno = 0;
  if (std::fwrite(data.data(), 1, data.size(), stdout) == data.size() && std::fflush(stdout) == 0) return true;
  if (errno != EPIPE) sayError(std::string("can't write to stdout: ") + std::strerror(errno));
  return false;
}

bool outputIsClosed() {
  pollfd output{STDOUT_FILENO, 0, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLNVAL)) != 0;
}

}  // namespace pongsim::cli
