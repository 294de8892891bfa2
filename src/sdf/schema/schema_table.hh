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

/// A row of the table in `tables/`: an element or attribute of SDF 1.4 to 1.12.
struct SchemaRow {
  /// Starts at the outermost element that means the same everywhere: "joint", "joint.axis",
  /// "joint.axis.xyz@expressed_in". "plugin.*" is any child.
  std::string_view path;
  /// Type of the value: "double", "pose"; empty: no value. "+pose": see the row "pose" and those below it.
  std::string_view type;
  /// A value of a column that a later version changes, written "OLD (VERSION: NEW)".
  template <class T>
  struct Versioned {
    T value{};
    /// The first version with `later`; 0: no version changes it.
    int changedIn = 0;
    T later{};

    const T& in(int version) const { return changedIn != 0 && version >= changedIn ? later : value; }
  };

  /// Default value; empty: none, or the empty text.
  Versioned<std::string_view> fallback;
  /// How often it occurs in its parent: '0' at most once, '1' once, '*' any number of times, '+' at least once.
  Versioned<char> presence;
  /// The first version that has it is SDF 1.`since`.
  int since;
  /// The first version without it is SDF 1.`removedIn`; 0: the newest has it.
  int removedIn;
  Use use;
  /// Its meaning, in one paragraph; empty: see the row that `type` refers to.
  std::string_view description;

  /// @return Whether SDF 1.`version` has it.
  bool isIn(int version) const { return since <= version && !isGoneIn(version); }
  /// @return Whether an earlier version than SDF 1.`version` had it.
  bool isGoneIn(int version) const { return removedIn != 0 && version >= removedIn; }
};

/// @return The whole table: the files in the order world, model, shape, sensor, camera, each sorted by path.
const std::vector<SchemaRow>& schemaTable();

}  // namespace pongsim::sdf
