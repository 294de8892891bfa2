#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ign/generation.hh"

namespace pongsim::ign {

/// The reply type of services without a reply.
inline constexpr std::string_view kNoReply = "ignition.msgs.Empty";

/// @return A message type's name on the wire: "gz.msgs.Twist" for "ignition.msgs.Twist", unless it is for Fortress.
std::string wireType(std::string type, Generation generation);

/// @return The name here of a type on the wire, whatever its generation: "ignition.msgs.Twist".
std::string ownType(std::string type);

/// @return The fully qualified name of a topic or service in this process's partition: "@/PARTITION@/clock"; nothing if
/// the name is not valid.
std::optional<std::string> wireName(const std::string& name);

}  // namespace pongsim::ign
