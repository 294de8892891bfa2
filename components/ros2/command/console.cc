#include "ros2/command/console.hh"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace pongsim::ros2 {

namespace {

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

int print(std::string_view data) {
  errno = 0;
  if (std::fwrite(data.data(), 1, data.size(), stdout) == data.size() && std::fflush(stdout) == 0) return kDone;
  if (errno != EPIPE) sayError(std::string("can't write to stdout: ") + std::strerror(errno));
  return kFailed;
}

}  // namespace pongsim::ros2
