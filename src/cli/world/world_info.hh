#pragma once

#include <string>

#include "pongsim/message.hh"

namespace pongsim::cli {

/// A world's content and progress, for people or as one JSON object.
/// @param step Its state, an `ignition.msgs.SerializedStepMap`.
std::string worldInfo(const Message& step, bool asJson);

}  // namespace pongsim::cli
