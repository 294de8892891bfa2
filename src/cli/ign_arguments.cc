#include "cli/ign_arguments.hh"

#include <algorithm>
#include <cctype>
#include <utility>

#include "cli/console.hh"

namespace pongsim::cli {

namespace {

/// What `-v` alone means there.
constexpr const char* kVerbose = "3";

bool isNumber(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

bool isCalledAsIgn(std::string_view program) {
  const std::size_t slash = program.rfind('/');
  const std::string_view name = slash == std::string_view::npos ? program : program.substr(slash + 1);
  return name == "ign" || name == "gz";
}

std::vector<std::string> fromIgnArguments(std::vector<std::string> arguments) {
  if (arguments.empty() || (arguments.front() != "gazebo" && arguments.front() != "sim")) return arguments;
  std::vector<std::string> result = {"run"};
  bool runs = false;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word == "-g") throw UsageError("there is no display here: '-g' shows nothing", "leave it out");
    if (word.starts_with("--network-")) {
      throw UsageError("one process runs all of a world here: there is no '" + word + "'",
                       "leave it out; '--levels' loads only what is near performers");
    }
    // without them there would be a display too, which there is never
    if (word == "-s" || word == "--headless-rendering") continue;
    if (word == "-r") runs = true;
    result.push_back(word);
    const bool isVerbosity = word == "-v" || word == "--verbose";
    if (isVerbosity && (i + 1 == arguments.size() || !isNumber(arguments[i + 1]))) result.emplace_back(kVerbose);
  }
  const bool isForHelp = std::any_of(result.begin(), result.end(),
                                     [](const std::string& word) { return word == "-h" || word == "--help"; });
  if (!runs && !isForHelp) result.emplace_back("--paused");
  return result;
}

}  // namespace pongsim::cli
