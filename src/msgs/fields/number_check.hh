#pragma once

#include <optional>
#include <string>

#include "pongsim/message.hh"

namespace pongsim::msgs {

/// @param largest What numbers with a point (float, double) may be, either way.
/// @return The first such number in the message, in lists and inner messages too, that is not finite or beyond
/// `largest`, or the first time that nanoseconds can't count: "linear.x is 1e+308". Nothing where all is well; then
/// nothing is allocated.
std::optional<std::string> unusableNumber(const Message& message, double largest);

}  // namespace pongsim::msgs
