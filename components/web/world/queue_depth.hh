#pragma once

#include <cstddef>
#include <string_view>

namespace pongsim::web {

/// @return How many messages of this type to queue for a client: 1 for states, of which only the latest matters, such
/// as poses, images and scans; more where each message matters.
std::size_t queueDepth(std::string_view messageType);

}  // namespace pongsim::web
