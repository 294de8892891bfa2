#pragma once

#include <string>

#include "ros2/types/type_description.hh"

/// The hash by which Jazzy and later tell whether two types are the same (REP 2016): SHA-256 of a description of the
/// type and of all that it has in it, in JSON.
namespace pongsim::ros2 {

/// @return "RIHS01_" and 64 digits.
std::string typeHash(const TypeDescription& type);

template <Structure Type>
std::string typeHash() {
  return typeHash(typeDescription<Type>());
}

}  // namespace pongsim::ros2
