#pragma once

#include <string>

#include "description/plugin.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads a `<plugin>`; a missing filename or name is an error.
/// @param owner "model 'robot'"
description::Plugin readPlugin(const Element& element, const std::string& owner, Context& context);

}  // namespace pongsim::sdf
