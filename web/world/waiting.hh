#pragma once

#include <cstddef>
#include <string_view>

namespace pongsim::web {

/// @return How many messages of that type may wait for a client: 1 of what is a state, of which only the latest counts,
/// such as poses, images and scans; more where each message says something of its own.
std::size_t mostWaiting(std::string_view messageType);

}  // namespace pongsim::web
