#pragma once

#include <deque>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "sdf/schema/schema_table.hh"

namespace pongsim::sdf {

/// Which elements and attributes the format knows, where, and what of each: SDF 1.4 to 1.9 in one.
class Schema {
 public:
  struct ElementType;

  /// An element or an attribute as a part of an element.
  struct Part {
    std::string_view name;
    /// As in the table, with what a row that is referred to says in place of what is empty.
    SchemaRow row;
    /// What may stand in it; null: neither elements nor attributes.
    const ElementType* type = nullptr;
    /// Anything may stand in it.
    bool isFreeForm = false;
  };

  /// Each sorted by name.
  struct ElementType {
    std::vector<Part> attributes;
    std::vector<Part> children;
  };

  static const Schema& instance();

  /// @return `<sdf>`.
  const Part& root() const { return *shared("sdf"); }

  /// @return An element whose meaning is the same wherever it stands, or null.
  const Part* shared(std::string_view name) const;

  /// @return All of those, sorted by name.
  std::span<const Part> allShared() const { return shared_; }

  /// @return What may stand in the element of that path in the table ("joint.axis"), or null.
  const ElementType* typeOf(std::string_view path) const;

  /// @return The part of that name, or null.
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
