#pragma once

#include <string_view>

#include "pongsim/message.hh"
#include "pongsim/random.hh"

namespace pongsim::faults {

/// Adds normally distributed noise to the floating-point numbers of a message
/// that are finite, in the order of its fields. Headers stay, and so do bytes
/// such as pixels.
/// @param field Only those of this field, "angular_velocity.z"; empty: all.
/// @return Whether there is such a field.
bool addNoise(Message& message, std::string_view field, double deviation, Random& random);

}  // namespace pongsim::faults
