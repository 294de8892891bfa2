#pragma once

#include "physics/engine.hh"
#include "pongsim/log.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::sim {

/// What the handles (`World`, `Model`, `Link`, `Joint`) reach into.
class Access {
 public:
  world::Entities& entities;
  world::State& state;
  physics::Engine& engine;
  Logger log{"commands"};
};

}  // namespace pongsim::sim
