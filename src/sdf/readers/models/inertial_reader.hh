#pragma once

#include <string>

#include "description/link.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Mass of the sun [kg]. The limit keeps squares and products of masses finite.
inline constexpr double kLargestMass = 1e30;

/// Reads the `<inertial>` of a link; without one: 1 kg and a unit inertia tensor.
/// @param owner "link 'l' of model 'm'"
/// @param isStatic The link never moves, so any mass will do.
description::Inertial readInertial(const Element& link, const std::string& owner, bool isStatic, Context& context);

}  // namespace pongsim::sdf
