#pragma once

#include <vector>

#include "description/world.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

description::World readWorld(const Element& element, Context& context);

/// What stands at the root of a file, outside of any world.
struct RootParts {
  std::vector<description::Model> models;
  std::vector<description::Light> lights;
};

/// @param element The `<sdf>` element.
RootParts readRootParts(const Element& element, Context& context);

}  // namespace pongsim::sdf
