#include "cli/view/sixel_terminal.hh"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <string>
#include <string_view>

#include "cli/key/key_terminal.hh"

namespace pongsim::cli {

namespace {

constexpr std::string_view kQuestion = "\033[c";
constexpr std::string_view kAnswer = "\033[?";

/// @return Whether an answer such as "\033[?62;4;22c" is complete; `numbers` gets its numbers.
bool isWhole(const std::string& said, std::string& numbers) {
  const std::size_t begin = said.find(kAnswer);
  if (begin == std::string::npos) return false;
  const std::size_t end = said.find('c', begin);
  if (end == std::string::npos) return false;
  numbers = said.substr(begin + kAnswer.size(), end - begin - kAnswer.size());
  return true;
}

}  // namespace

bool knowsSixels(int input, int output, std::chrono::milliseconds patience) {
  const KeyTerminal terminal(input);
  if (!terminal.isTerminal() || isatty(output) == 0) return false;
  if (write(output, kQuestion.data(), kQuestion.size()) != static_cast<ssize_t>(kQuestion.size())) return false;
  const auto deadline = std::chrono::steady_clock::now() + patience;
  std::string said, numbers;
  while (!isWhole(said, numbers)) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    pollfd descriptor{input, POLLIN, 0};
    if (left <= 0 || poll(&descriptor, 1, static_cast<int>(left)) <= 0) return false;
    std::array<char, 64> bytes{};
    const ssize_t count = read(input, bytes.data(), bytes.size());
    if (count <= 0) return false;
    said.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return (";" + numbers + ";").find(";4;") != std::string::npos;
}

}  // namespace pongsim::cli
