#include "ros2/node/names.hh"

namespace pongsim::ros2 {

namespace {

constexpr std::string_view kTopic = "rt", kRequest = "rq", kReply = "rr";
constexpr std::string_view kRequestEnd = "Request", kReplyEnd = "Reply";

bool isDigit(char letter) { return letter >= '0' && letter <= '9'; }
bool isLetter(char letter) { return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z'); }
bool isAllowed(char letter) { return isDigit(letter) || isLetter(letter) || letter == '_' || letter == '/'; }

}  // namespace

std::optional<std::string> rosNameError(std::string_view name) {
  if (name.size() < 2 || name.front() != '/') return "is not an absolute name";
  if (name.back() == '/') return "ends with a slash";
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char letter = name[i];
    if (!isAllowed(letter)) return "has a '" + std::string(1, letter) + "', which ROS does not allow in names";
    if (i == 0 || name[i - 1] != '/') continue;
    if (letter == '/') return "has two slashes in a row";
    if (isDigit(letter)) return "has a word that begins with the digit " + std::string(1, letter);
  }
  return std::nullopt;
}

std::string absoluteName(std::string_view nameSpace, std::string_view name) {
  if (name.starts_with('/')) return std::string(name);
  std::string space(nameSpace);
  while (space.ends_with('/')) space.pop_back();
  if (!space.empty() && !space.starts_with('/')) space.insert(0, "/");
  return space + "/" + std::string(name);
}

std::string rosNameFor(std::string_view topic) {
  std::string name;
  for (const char letter : topic) {
    const bool beginsWord = name.empty() || name.back() == '/';
    if (letter == '/' && beginsWord && !name.empty()) continue;
    if (name.empty() && letter != '/') name += '/';
    if (beginsWord && isDigit(letter)) name += '_';
    name += isAllowed(letter) ? letter : '_';
  }
  while (name.size() > 1 && name.ends_with('/')) name.pop_back();
  return name;
}

std::string topicOnWire(std::string_view name) { return std::string(kTopic) + std::string(name); }
std::string requestOnWire(std::string_view service) {
  return std::string(kRequest) + std::string(service) + std::string(kRequestEnd);
}
std::string replyOnWire(std::string_view service) {
  return std::string(kReply) + std::string(service) + std::string(kReplyEnd);
}

std::optional<std::string> topicFromWire(std::string_view wireName) {
  if (!wireName.starts_with("rt/")) return std::nullopt;
  return std::string(wireName.substr(kTopic.size()));
}

std::optional<std::string> serviceFromWire(std::string_view wireName) {
  if (!wireName.starts_with("rq/") || !wireName.ends_with(kRequestEnd)) return std::nullopt;
  return std::string(wireName.substr(kRequest.size(), wireName.size() - kRequest.size() - kRequestEnd.size()));
}

}  // namespace pongsim::ros2
