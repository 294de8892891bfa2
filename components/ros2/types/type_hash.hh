#pragma once

#include <string>

#include "ros2/types/type_description.hh"

/// The hash by which Jazzy and later identify types (REP 2016): the SHA-256 of a JSON description of the type and of
/// all types inside it.
namespace pongsim::ros2 {

/// @return "RIHS01_" and 64 digits.
std::string typeHash(const TypeDescription& type);

template <Structure Type>
std::string typeHash() {
  return typeHash(typeDescription<Type>());
}

}  // namespace pongsim::ros2
