#include "transport/names/topic_name.hh"

#include <optional>
#include <stdexcept>
#include <utility>

#include "pongsim/node.hh"

namespace pongsim {

namespace {

// What DDS can tell others as a topic's name.
constexpr std::size_t kLongestTopic = 255;

}  // namespace

std::optional<std::string> topicNameError(std::string_view name) {
  if (name.empty()) return "is empty";
  if (name == "/") return "is only a slash";
  if (name.find(' ') != std::string_view::npos) return "has a space";
  for (std::string_view forbidden : {"~", "//", "@", ":="}) {
    if (name.find(forbidden) != std::string_view::npos) return "has '" + std::string(forbidden) + "'";
  }
  if (name.size() + (name.starts_with('/') ? 0 : 1) > kLongestTopic) return "is longer than 255 characters";
  return std::nullopt;
}

std::string cleanTopic(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    if (text.starts_with("//") || text.starts_with(":=")) {
      text.remove_prefix(2);
      continue;
    }
    if (text.front() != '@' && text.front() != '~') name += text.front() == ' ' ? '_' : text.front();
    text.remove_prefix(1);
  }
  return name;
}

namespace transport {

std::string absoluteTopic(std::string_view name) {
  if (const std::optional<std::string> error = topicNameError(name)) {
    throw std::invalid_argument("'" + std::string(name) + "' is not a topic name: it " + *error);
  }
  if (name.ends_with('/')) name.remove_suffix(1);
  return name.starts_with('/') ? std::string(name) : "/" + std::string(name);
}

}  // namespace transport

}  // namespace pongsim
