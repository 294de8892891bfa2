#pragma once

#include <chrono>
#include <string>

#include "pongsim/message.hh"

namespace pongsim {
class Transport;
}

namespace pongsim::cli {

/// Asks a world for its state. Reports failures.
/// @param world Its name as used in topics.
/// @return An `ignition.msgs.SerializedStepMap`, or null.
MessagePointer askForState(Transport& transport, const std::string& world, std::chrono::nanoseconds timeout);

}  // namespace pongsim::cli
