#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::ign {

/// The reply type of services that send no reply, by the rules of ign-transport.
inline constexpr std::string_view kNoReply = "ignition.msgs.Empty";

/// @return The name of a topic or service on the wire, in this process's partition: "@/PARTITION@/clock"; nothing if it
/// can't have one.
std::optional<std::string> wireName(const std::string& name);

}  // namespace pongsim::ign
