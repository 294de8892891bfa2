#pragma once

#include <string>

#include "ros2/types/type_description.hh"

/// A type in the language of .msg files, as bags have it with their messages. Comments, constants and defaults, which
/// nobody needs to read messages, are not in it.
namespace pongsim::ros2 {

/// @return The type's fields, and behind them those of all types in it, as MCAP's "ros2msg" has them
/// (https://mcap.dev/spec/registry).
std::string messageDefinition(const TypeDescription& type);

template <Structure Type>
std::string messageDefinition() {
  return messageDefinition(typeDescription<Type>());
}

}  // namespace pongsim::ros2
