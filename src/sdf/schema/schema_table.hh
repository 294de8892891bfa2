#pragma once

#include <array>
#include <span>
#include <string_view>

namespace pongsim::sdf {

enum class Use {
  /// The description holds what it says.
  kRead,
  /// The description holds the element that it is in as it stands in the file; its type is checked.
  kKept,
  /// It is known, its type is checked, and the description does not tell of it.
  kPassed,
};

/// One line of the table of elements: an element or an attribute, SDF 1.4 to 1.9 in one, and what of later versions is
/// read in any.
struct SchemaRow {
  /// From the outermost element whose meaning is the same wherever it stands: "joint", "joint.axis",
  /// "joint.axis.xyz@expressed_in". "plugin.*" stands for any child.
  std::string_view path;
  /// Of the value: "double", "pose"; empty where there is none. "+pose": as the row "pose" and those below it say.
  std::string_view type;
  /// The value where the file gives none; empty: there is no such value, or it is the empty text.
  std::string_view fallback;
  /// How often it stands in its parent: '0' once at most, '1' once, '*' any number of times, '+' once at least.
  char presence;
  /// SDF 1.`since` is the first version to have it.
  int since;
  /// SDF 1.`removedIn` no longer has it; 0: 1.9 has it.
  int removedIn;
  Use use;
  /// What it means, in one paragraph; empty: as the row says that `type` refers to.
  std::string_view description;
};

// The table, a part each, each sorted by path.
std::span<const SchemaRow> worldRows();
std::span<const SchemaRow> modelRows();
std::span<const SchemaRow> shapeRows();
std::span<const SchemaRow> sensorRows();
std::span<const SchemaRow> cameraRows();

/// @return All of it.
inline std::array<std::span<const SchemaRow>, 5> schemaTables() {
  return {worldRows(), modelRows(), shapeRows(), sensorRows(), cameraRows()};
}

}  // namespace pongsim::sdf
