#pragma once

#include <optional>
#include <string>

#include "pongsim/message.hh"

namespace pongsim::msgs {

/// @param largest Largest allowed magnitude of floating-point numbers (float, double).
/// @return The first such number in the message, including lists and nested messages, that is not finite or exceeds
/// `largest`, or the first time that does not fit in nanoseconds: "linear.x is 1e+308". Nothing if all is well, and
/// then nothing is allocated.
std::optional<std::string> unusableNumber(const Message& message, double largest);

}  // namespace pongsim::msgs
