#pragma once

#include <deque>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "sdf/schema/schema_table.hh"

namespace pongsim::sdf {

/// The elements and attributes of SDF 1.4 to 1.12 in one schema.
class Schema {
 public:
  struct ElementType;

  /// An element or attribute, as a child of one parent element.
  struct Part {
    std::string_view name;
    /// The table's row; its empty fields are filled from the row that it refers to.
    SchemaRow row;
    /// Its possible children and attributes; null: none.
    const ElementType* type = nullptr;
    /// Whether it can have any children.
    bool isFreeForm = false;
  };

  /// Both sorted by name.
  struct ElementType {
    std::vector<Part> attributes;
    std::vector<Part> children;
  };

  static const Schema& instance();

  /// @return `<sdf>`.
  const Part& root() const { return *shared("sdf"); }

  /// @return The element with this name if it is defined once for all parents ("joint", "pose"), or null.
  const Part* shared(std::string_view name) const;

  /// @return All elements that are defined once for all parents, sorted by name.
  std::span<const Part> allShared() const { return shared_; }

  /// @return What the element with this path in the table ("joint.axis") can contain, or null.
  const ElementType* typeOf(std::string_view path) const;

  /// @return The part with this name, or null.
  static const Part* find(std::span<const Part> parts, std::string_view name);

 private:
  Schema();
  void addRows();
  void resolve(Part& part);
  ElementType& typeAt(std::string_view path);

  std::deque<ElementType> types_;
  std::unordered_map<std::string_view, ElementType*> typeOfPath_;
  std::vector<Part> shared_;
};

}  // namespace pongsim::sdf
