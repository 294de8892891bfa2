#pragma once

#include <string_view>

namespace pongsim::web {

/// @return Whether a call to that service changes nothing, so that clients that may only look may call it.
bool isHarmless(std::string_view service);

}  // namespace pongsim::web
