#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace pongsim::log {

/// What a file says of a type besides its name, so that others can read its messages.
struct Definition {
  /// "protobuf" or "ros2msg"; "" where nothing is known.
  std::string schemaEncoding;
  std::string schema;
  /// "protobuf" or "cdr".
  std::string messageEncoding;
  /// What else is said of the topic: of ROS "offered_qos_profiles".
  std::map<std::string, std::string> metadata = {};
  bool operator==(const Definition&) const = default;
};

/// Tells of a topic's messages, by its name and the full name of their type.
using Definitions = std::function<Definition(std::string_view topic, std::string_view type)>;

/// @return Of a type of ignition.msgs, a FileDescriptorSet: its file and those that it imports, each after what it
/// imports itself. Of a type that is not known here, nothing but that it is protobuf.
Definition protobufDefinition(std::string_view type);

}  // namespace pongsim::log
