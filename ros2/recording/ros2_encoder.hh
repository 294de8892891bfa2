#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pongsim/messages/message_encoder.hh"
#include "ros2/config/topic_rule.hh"

namespace pongsim::ros2 {

/// Turns topics of the simulation into those that nodes of ROS see of it: by the rules that name them, the others under
/// their own names in the type of their default pair. The odometry of robots, which on the wire is on /tf, is there
/// too.
class Ros2Encoder final : public MessageEncoder {
 public:
  /// @param settings "config_file": a configuration of ros_gz_bridge; its directions do not count here.
  static std::unique_ptr<MessageEncoder> make(const EncoderSettings& settings, Diagnostics& diagnostics);

  explicit Ros2Encoder(std::vector<TopicRule> rules) : rules_(std::move(rules)) {}

  std::string_view profile() const override { return "ros2"; }
  std::variant<std::unique_ptr<TopicEncoder>, std::string> openTopic(std::string_view topic,
                                                                     std::string_view type) override;

 private:
  std::variant<std::vector<TopicRule>, std::string> rulesFor(const std::string& topic, const std::string& type) const;
  std::string takenBy(const TopicRule& rule) const;

  std::vector<TopicRule> rules_;
  /// Who has a name in ROS.
  std::map<std::string, TopicRule> taken_;
};

}  // namespace pongsim::ros2
