#pragma once

#include <string>

#include "sdf/schema/schema_path.hh"

namespace pongsim::cli {

/// @return What the format says of an element or attribute, and a line for each that may stand in it.
std::string describe(const sdf::NamedPart& named);

}  // namespace pongsim::cli
