#pragma once

#include <string>

#include "description/link.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads a `<visual>`, except for its pose.
/// @param owner "link 'l' of model 'm'"
description::Visual readVisual(const Element& element, const std::string& owner, Context& context);

}  // namespace pongsim::sdf
