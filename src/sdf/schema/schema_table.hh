#pragma once

#include <string_view>
#include <vector>

namespace pongsim::sdf {

enum class Use {
  /// Read into the description.
  kRead,
  /// The enclosing element is kept in the description as written; the type is checked.
  kKept,
  /// Known, and its type is checked, but not part of the description.
  kPassed,
};

/// A row of the table in `tables/`: an element or attribute of SDF 1.4 to 1.9, or of a later version if it is read in
/// any.
struct SchemaRow {
  /// Starts at the outermost element that means the same everywhere: "joint", "joint.axis",
  /// "joint.axis.xyz@expressed_in". "plugin.*" is any child.
  std::string_view path;
  /// Type of the value: "double", "pose"; empty: no value. "+pose": see the row "pose" and those below it.
  std::string_view type;
  /// Default value; empty: none, or the empty text.
  std::string_view fallback;
  /// How often it occurs in its parent: '0' at most once, '1' once, '*' any number of times, '+' at least once.
  char presence;
  /// The first version that has it is SDF 1.`since`.
  int since;
  /// The first version without it is SDF 1.`removedIn`; 0: 1.9 has it.
  int removedIn;
  Use use;
  /// Its meaning, in one paragraph; empty: see the row that `type` refers to.
  std::string_view description;
};

/// @return The whole table: the files in the order world, model, shape, sensor, camera, each sorted by path.
const std::vector<SchemaRow>& schemaTable();

}  // namespace pongsim::sdf
