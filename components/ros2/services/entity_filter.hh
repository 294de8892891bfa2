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

/// Selects entities as a request asks.
class EntityFilter {
 public:
  /// @param request An entity must match all of it.
  /// @param result Why there is no filter: an invalid expression, or bounds that are invalid or of an unknown type.
  static std::optional<EntityFilter> from(const simulation_interfaces::EntityFilters& request, Result& result);

  EntityFilter(EntityFilter&&) noexcept;
  ~EntityFilter();

  bool takes(const World& world, const Model& model, const EntityInfos& infos) const;

 private:
  EntityFilter();
  simulation_interfaces::EntityFilters request_;
  /// Matched anywhere in names; null: all match.
  std::unique_ptr<re2::RE2> names_;
  std::optional<Region> region_;
};

}  // namespace pongsim::ros2
