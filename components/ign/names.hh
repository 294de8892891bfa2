#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::ign {

/// The reply type in ign-transport of services without a reply.
inline constexpr std::string_view kNoReply = "ignition.msgs.Empty";

/// @return The fully qualified name of a topic or service in this process's partition: "@/PARTITION@/clock"; nothing if
/// the name is not valid.
std::optional<std::string> wireName(const std::string& name);

}  // namespace pongsim::ign
