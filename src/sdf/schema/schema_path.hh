#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sdf/schema/schema.hh"

namespace pongsim::sdf {

/// What a path names in the format.
struct NamedPart {
  const Schema::Part* part;
  bool isAttribute;
  /// The elements in which it stands, by their paths in the table ("joint.axis"), sorted; none for `<sdf>`.
  std::vector<std::string_view> holders;
};

/// Why a path names nothing, or not one thing.
struct NoPart {
  std::string message;
  std::string hint;
};

/// Finds an element or attribute of the format.
/// @param path "joint", "joint/axis/limit", "//link/inertial", "joint/@type". It may begin anywhere, as long as only
/// one thing is meant.
std::variant<NamedPart, NoPart> findPart(std::string_view path);

/// @return "joint/axis/xyz/@expressed_in" for a path of the table.
std::string userPath(std::string_view tablePath);

}  // namespace pongsim::sdf
