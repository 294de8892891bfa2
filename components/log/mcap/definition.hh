#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace pongsim::log {

/// What a file says about a type besides its name, so that other programs can read its messages.
struct Definition {
  /// "protobuf" or "ros2msg"; "" if unknown.
  std::string schemaEncoding;
  std::string schema;
  /// "protobuf" or "cdr".
  std::string messageEncoding;
  /// Further metadata of the topic: for ROS, "offered_qos_profiles".
  std::map<std::string, std::string> metadata = {};
  bool operator==(const Definition&) const = default;
};

/// Returns the definition of a topic's messages, given its name and the full name of their type.
using Definitions = std::function<Definition(std::string_view topic, std::string_view type)>;

/// @return For a type of ignition.msgs, a FileDescriptorSet: its file and those that it imports, each after its own
/// imports. For unknown types, only that they are protobuf.
Definition protobufDefinition(std::string_view type);

}  // namespace pongsim::log
