#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ros2/services/bounds.hh"
#include "ros2/services/entity_info.hh"

namespace re2 {
class RE2;
}

namespace pongsim::ros2 {

/// Which entities a request means.
class EntityFilter {
 public:
  /// @param asked All of it must apply.
  /// @param result Why there is none: an expression that is none, bounds that make no sense or are of an unknown type.
  static std::optional<EntityFilter> from(const simulation_interfaces::EntityFilters& asked, Result& result);

  EntityFilter(EntityFilter&&) noexcept;
  ~EntityFilter();

  bool takes(const Model& model, const EntityInfos& infos) const;

 private:
  EntityFilter();
  simulation_interfaces::EntityFilters asked_;
  /// Searched for in names; null: all are taken.
  std::unique_ptr<re2::RE2> names_;
  std::optional<Region> region_;
};

}  // namespace pongsim::ros2
