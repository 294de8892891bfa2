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
/// @param hasAnswered Whether it has answered before: if it no longer does, it has ended.
/// @return An `ignition.msgs.SerializedStepMap`, or null.
MessagePointer askForState(Transport& transport, const std::string& world, std::chrono::nanoseconds timeout,
                           bool hasAnswered = false);

}  // namespace pongsim::cli
