#pragma once

#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace pongsim::sdf {

/// Which elements and attributes the format knows, and where: SDF 1.4 to 1.9 in one.
class Schema {
 public:
  struct ElementType;

  /// An element or an attribute as a part of an element.
  struct Part {
    std::string_view name;
    /// The version 1.`removedIn` no longer has it; 0: 1.9 still has it.
    int removedIn = 0;
    /// What may stand in it; null: neither elements nor attributes.
    const ElementType* type = nullptr;
    /// Anything may stand in it.
    bool isFreeForm = false;
  };

  struct ElementType {
    std::vector<Part> attributes;
    std::vector<Part> children;
  };

  static const Schema& instance();

  /// @return What may stand in `<sdf>`.
  const ElementType& root() const { return *shared("sdf"); }

  /// @return What may stand in an element whose meaning is the same wherever it stands, or null.
  const ElementType* shared(std::string_view name) const;

  /// @return The part of that name, or null.
  static const Part* find(std::span<const Part> parts, std::string_view name);

 private:
  Schema();
  std::vector<ElementType> types_;
  std::unordered_map<std::string_view, const ElementType*> typeOfPath_;
};

/// One line of the table of elements.
struct SchemaRow {
  /// Path of an element, from the outermost one whose meaning is the same wherever it stands: "joint.axis".
  std::string_view path;
  /// Names of its attributes, then of its children, sorted, with spaces between. "name<7" is in no version from 1.7
  /// on; "+name" has a row of its own as "name", "*name" may hold anything.
  std::string_view attributes;
  std::string_view children;
};

/// @return The table, sorted by path.
std::span<const SchemaRow> schemaRows();

}  // namespace pongsim::sdf
