#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "pongsim/messages/message_decoder.hh"
#include "pongsim/messages/message_encoder.hh"
#include "web/world/recent_log.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::rosbridge {

/// In a second.
inline constexpr std::uint64_t kNanoseconds = 1'000'000'000;

/// A topic of a world as it is in ROS.
struct RosTopic {
  /// "/scan"
  std::string name;
  /// "sensor_msgs/msg/LaserScan"
  std::string type;
  Worlds::TopicPlace place;
  /// Its place in the encoder's `topics`.
  std::size_t index = 0;
};

/// @return "geometry_msgs/msg/Twist" for "geometry_msgs/Twist", the form of ROS 1, too.
std::string fullRosType(std::string_view type);

/// The topics of the worlds by their names in ROS, and their encoders and decoders. For the server's thread.
class RosTopics {
 public:
  /// @param log Must outlive it.
  RosTopics(std::shared_ptr<Worlds> worlds, RecentLog& log) : worlds_(std::move(worlds)), log_(log) {}

  /// @return What /rosout tells.
  RecentLog& log() const { return log_; }

  /// @return Why topics can't be converted; empty: they can.
  const std::string& fault();

  /// @return All that have a counterpart in ROS, sorted by the names of the simulation. Several may have one name in
  /// ROS, such as /tf.
  std::vector<RosTopic> all();
  /// @return Those with this name in ROS.
  std::vector<RosTopic> find(std::string_view name);

  /// @return An encoder for a topic that `all` has.
  std::unique_ptr<TopicEncoder> encoder(const RosTopic& topic);
  /// See `MessageDecoder::openInput`.
  std::variant<std::unique_ptr<TopicDecoder>, std::string> decoder(std::string_view rosType, std::string_view type);
  /// @return The definition of a topic's type.
  std::string definition(const RosTopic& topic);

 private:
  bool open();
  /// Names and types in ROS; empty: none.
  using Names = std::vector<std::pair<std::string, std::string>>;
  const Names& namesOf(const Topic& topic);

  const std::shared_ptr<Worlds> worlds_;
  RecentLog& log_;
  bool isOpened_ = false;
  std::unique_ptr<MessageEncoder> encoding_;
  std::string fault_;
  /// By name and type in the simulation.
  std::map<std::pair<std::string, std::string>, Names> names_;
};

}  // namespace pongsim::web::rosbridge
