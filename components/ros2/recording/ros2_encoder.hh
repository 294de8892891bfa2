#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pongsim/messages/message_decoder.hh"
#include "pongsim/messages/message_encoder.hh"
#include "ros2/config/topic_rule.hh"

namespace pongsim::ros2 {

/// Converts topics of the simulation to what ROS nodes would receive: by the rules that name them, all others under
/// their own names with their default pair. Also covers the robots' odometry, which on the wire is part of /tf.
class Ros2Encoder final : public MessageEncoder, public MessageDecoder {
 public:
  /// @param settings "config_file": a configuration of ros_gz_bridge, whose directions are ignored here.
  static std::unique_ptr<MessageEncoder> make(const EncoderSettings& settings, Diagnostics& diagnostics);

  explicit Ros2Encoder(std::vector<TopicRule> rules) : rules_(std::move(rules)) {}

  std::string_view profile() const override { return "ros2"; }
  std::variant<std::unique_ptr<TopicEncoder>, std::string> openTopic(std::string_view topic,
                                                                     std::string_view type) override;
  std::variant<std::unique_ptr<TopicDecoder>, std::string> openInput(std::string_view ros,
                                                                     std::string_view type) override;

 private:
  std::variant<std::vector<TopicRule>, std::string> rulesFor(const std::string& topic, const std::string& type) const;
  std::string takenBy(const TopicRule& rule) const;

  std::vector<TopicRule> rules_;
  /// The topic that uses each ROS name.
  std::map<std::string, TopicRule> taken_;
};

}  // namespace pongsim::ros2
