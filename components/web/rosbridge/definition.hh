#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::web::rosbridge {

/// A type that is not a list.
enum class Kind {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kString,
  kMessage
};

enum class Count { kOne, kArray, kList };

struct RosField {
  std::string name;
  Kind kind = Kind::kBool;
  /// Of a message: its type's index in the definition.
  std::size_t type = 0;
  Count count = Count::kOne;
  /// Of an array.
  std::size_t size = 0;
};

/// The fields of a message type, first, and of all types inside it.
struct RosDefinition {
  std::vector<std::vector<RosField>> types;
};

/// Reads a definition in MCAP's format "ros2msg" (https://mcap.dev/spec/registry).
/// @return Nothing if it is not one, or a type contains itself.
std::optional<RosDefinition> readDefinition(std::string_view text);

}  // namespace pongsim::web::rosbridge
