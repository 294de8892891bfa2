#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sdf/schema/schema.hh"

namespace pongsim::sdf {

/// The part of the format that a path names.
struct NamedPart {
  const Schema::Part* part;
  bool isAttribute;
  /// Paths in the table of the elements that contain it ("joint.axis"), sorted; none for `<sdf>`.
  std::vector<std::string_view> holders;
};

/// Why a path names nothing, or more than one thing.
struct NoPart {
  std::string message;
  std::string hint;
};

/// Finds an element or attribute of the format.
/// @param path "joint", "joint/axis/limit", "//link/inertial", "joint/@type". Leading elements can be left out as long
/// as the path is unambiguous.
std::variant<NamedPart, NoPart> findPart(std::string_view path);

/// @return "joint/axis/xyz/@expressed_in" for a path of the table.
std::string userPath(std::string_view tablePath);

}  // namespace pongsim::sdf
