#pragma once

#include <string>

#include "pongsim/element.hh"
#include "pongsim/semantics.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<gz:semantics>` of a model, which Gazebo's system EntitySemantics reads there.
/// @param owner "model 'm'"
Semantics readSemantics(const Element& model, const std::string& owner, Context& context);

}  // namespace pongsim::sdf
