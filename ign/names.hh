#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::ign {

/// What a service answers with that, by the rules of ign-transport, sends no answer.
inline constexpr std::string_view kNoReply = "ignition.msgs.Empty";

/// @return The name that a topic or service has on the wire: "@/PARTITION@/clock", in this process's partition; nothing
/// where it can't have one.
std::optional<std::string> wireName(const std::string& name);

}  // namespace pongsim::ign
