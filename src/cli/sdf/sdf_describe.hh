#pragma once

#include <string>

#include "sdf/schema/schema_path.hh"

namespace pongsim::cli {

/// @return The format's description of an element or attribute, and one line for each of its children.
std::string describe(const sdf::NamedPart& named);

}  // namespace pongsim::cli
