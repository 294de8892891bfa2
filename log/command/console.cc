#include "log/command/console.hh"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace pongsim::log {

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

void say(std::string_view message) { writeError("pongsim: " + std::string(message)); }

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  if (errno != EPIPE) throw Failure(std::string("cannot write to stdout: ") + std::strerror(errno));
}

}  // namespace pongsim::log
