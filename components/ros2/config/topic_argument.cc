#include "ros2/config/topic_argument.hh"

#include <string>

namespace pongsim::ros2 {

namespace {

constexpr const char* kHint =
    "TOPIC@ROS_TYPE@IGNITION_TYPE, with [ in place of the second @ for to ROS only, ] for from ROS only";

}  // namespace

std::optional<RuleText> readTopicArgument(std::string_view text, const SourcePosition& position,
                                          Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why) {
    diagnostics.error(position, "'" + std::string(text) + "' " + why, kHint);
    return std::nullopt;
  };
  const std::size_t first = text.find('@');
  if (first == std::string_view::npos || first == 0) return refuse("has no topic before the '@'");
  std::string_view rest = text.substr(first + 1);
  // as in ros_gz, a second @ takes precedence over the others
  std::size_t second = rest.find('@');
  if (second == std::string_view::npos) second = rest.find_first_of("[]");

  RuleText rule;
  rule.position = position;
  const auto said = [&](std::string_view word) { return GivenText{std::string(word), position}; };
  rule.ros = rule.ignition = said(text.substr(0, first));
  rule.rosType = said(rest.substr(0, second));
  if (rule.rosType->text.empty()) return refuse("has no ROS type");
  rule.isService = rule.rosType->text.find("/srv/") != std::string::npos;
  if (second == std::string_view::npos) {
    if (!rule.isService) return refuse("has no simulation type");
    return rule;
  }
  const char between = rest[second];
  rest.remove_prefix(second + 1);
  if (rule.isService) {
    if (between != '@') return refuse("is a service, which has no direction");
    const std::size_t third = rest.find('@');
    if (third == std::string_view::npos || third == 0 || third + 1 == rest.size()) {
      return refuse("is a service: give both types or neither: SERVICE@ROS_TYPE@REQUEST@REPLY");
    }
    rule.requestType = said(rest.substr(0, third));
    rule.replyType = said(rest.substr(third + 1));
    return rule;
  }
  if (rest.empty()) return refuse("has no simulation type");
  if (rest.find_first_of("@[]") != std::string_view::npos) return refuse("has more than two types");
  rule.ignitionType = said(rest);
  rule.direction = between == '[' ? Direction::kToRos : between == ']' ? Direction::kFromRos : Direction::kBoth;
  return rule;
}

}  // namespace pongsim::ros2
