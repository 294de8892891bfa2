#pragma once

#include "description/material.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads a `<material>`.
description::Material readMaterial(const Element& element, Context& context);

}  // namespace pongsim::sdf
