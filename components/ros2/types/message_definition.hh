#pragma once

#include <string>

#include "ros2/types/type_description.hh"

/// Message definitions in the .msg language, as stored in bags. They contain no comments, constants and defaults, which
/// are not needed for reading messages.
namespace pongsim::ros2 {

/// @return The type's fields, followed by those of all types inside it, in MCAP's "ros2msg" format
/// (https://mcap.dev/spec/registry).
std::string messageDefinition(const TypeDescription& type);

template <Structure Type>
std::string messageDefinition() {
  return messageDefinition(typeDescription<Type>());
}

}  // namespace pongsim::ros2
