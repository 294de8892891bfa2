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
  /// The resolved frames.
  std::unique_ptr<Scope> scope;
};

WorldParts readWorld(const Element& element, Context& context);

/// What a file's root contains outside of worlds.
struct RootParts {
  std::vector<description::Model> models;
  std::vector<description::Light> lights;
  std::vector<description::Actor> actors;
  /// The resolved frames.
  std::unique_ptr<Scope> scope;
};

/// @param element The `<sdf>` element.
RootParts readRootParts(const Element& element, Context& context);

}  // namespace pongsim::sdf
