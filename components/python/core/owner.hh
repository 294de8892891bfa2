#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/life.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::python {

/// Held by Python's Simulation: the simulation is destroyed with it.
struct Owner {
  explicit Owner(std::shared_ptr<Life> owned) : life(std::move(owned)) {}
  Owner(Owner&&) = default;
  ~Owner() {
    if (life) life->release();
  }
  std::shared_ptr<Life> life;
  std::vector<Diagnostic> found;
};

}  // namespace pongsim::python
