// Arbitrary lines as words of a command line. Parsing must end with a command to run or an error message. The command
// is not run.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "cli/cli.hh"
#include "shared/program/failure.hh"

namespace {

/// Help goes to stdout, which is discarded.
[[maybe_unused]] const bool kQuiet = std::freopen("/dev/null", "w", stdout) != nullptr;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<std::string> words = {"pongsim"};
  for (std::string word; std::getline(text, word);) {
    // a shell cannot pass such words
    if (word.find('\0') != std::string::npos) return 0;
    // files named on a command line are read at once, and stdin and devices may never end
    if (word.find("/dev/") != std::string::npos || word == "-" || word == "--file=-") return 0;
    words.push_back(std::move(word));
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  try {
    pongsim::cli::workOf(static_cast<int>(arguments.size()), arguments.data());
  } catch (const pongsim::cli::UsageError& error) {
    if (std::string(error.what()).empty()) std::abort();
  }
  return 0;
}
