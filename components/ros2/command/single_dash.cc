#include "ros2/command/single_dash.hh"

#include <algorithm>

namespace pongsim::ros2 {

namespace {

constexpr std::string_view kTrue[] = {"1", "t", "true", "y", "yes", "True"};
constexpr std::string_view kFalse[] = {"0", "f", "false", "n", "no", "False"};

bool isOneOf(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::vector<std::string> withTwoDashes(const std::vector<std::string>& words, const SingleDashOptions& options) {
  std::vector<std::string> changed;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    std::string_view name = word;
    if (name.starts_with('-')) name.remove_prefix(name.starts_with("--") ? 2 : 1);
    const std::size_t equals = name.find('=');
    const std::string_view value = equals == std::string_view::npos ? std::string_view() : name.substr(equals + 1);
    name = name.substr(0, equals);
    const bool hasNext = i + 1 < words.size();
    if (!word.starts_with('-')) {
      changed.push_back(word);
    } else if (isOneOf(name, options.withValue)) {
      const std::string option = "--" + std::string(name);
      if (equals != std::string_view::npos) {
        changed.push_back(option + "=" + std::string(value));
      } else {
        changed.push_back(hasNext ? option + "=" + words[++i] : option);
      }
    } else if (isOneOf(name, options.flags) && (equals == std::string_view::npos || isOneOf(value, kTrue))) {
      changed.push_back("--" + std::string(name));
      if (hasNext && (isOneOf(words[i + 1], kTrue) || isOneOf(words[i + 1], kFalse))) ++i;
    } else if (isOneOf(name, options.flags) && isOneOf(value, kFalse)) {
      continue;
    } else if (name.starts_with("no") && isOneOf(name.substr(2), options.flags)) {
      continue;
    } else {
      changed.push_back(word);
    }
  }
  return changed;
}

}  // namespace pongsim::ros2
