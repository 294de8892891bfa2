#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/geometry.hh"
#include "description/world.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::test {

/// A world of visuals for tests of sensors. Each visual has a model of its own with one link at the model's origin.
class VisualWorld {
 public:
  description::Visual& add(const description::Geometry& geometry, const Pose& X_WorldModel = {}, bool isStatic = true) {
    description::Model& model = world_.models.emplace_back();
    model.name = "m" + std::to_string(world_.models.size());
    model.X_ParentModel = X_WorldModel;
    model.isStatic = isStatic;
    model.canonicalLink = "l";
    model.links.resize(1);
    model.links[0].name = "l";
    description::Visual& visual = model.links[0].visuals.emplace_back();
    visual.name = "v";
    visual.geometry = geometry;
    return visual;
  }

  description::World& description() { return world_; }
  ModelId id(std::size_t model) const { return entities_->models()[model].id; }
  const std::vector<Diagnostic>& warnings() const { return diagnostics_.all(); }

 protected:
  /// Creates entities and state from the description.
  void populate() {
    entities_.emplace(world_);
    state_.emplace(*entities_);
  }

  const world::Entities& entities() const { return *entities_; }
  world::State& state() { return *state_; }
  Diagnostics& diagnostics() { return diagnostics_; }

 private:
  description::World world_;
  std::optional<world::Entities> entities_;
  std::optional<world::State> state_;
  Diagnostics diagnostics_;
};

}  // namespace pongsim::test
