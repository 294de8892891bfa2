#pragma once

#include <memory>
#include <vector>

#include "description/world.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"

namespace pongsim::sdf {

struct WorldParts {
  description::World world;
  /// Its frames, resolved.
  std::unique_ptr<Scope> scope;
};

WorldParts readWorld(const Element& element, Context& context);

/// What stands at the root of a file, outside of any world.
struct RootParts {
  std::vector<description::Model> models;
  std::vector<description::Light> lights;
  std::vector<description::Actor> actors;
  /// Their frames, resolved.
  std::unique_ptr<Scope> scope;
};

/// @param element The `<sdf>` element.
RootParts readRootParts(const Element& element, Context& context);

}  // namespace pongsim::sdf
