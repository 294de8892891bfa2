#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Applies the overrides in an `<include>` (name, pose, static, placement_frame, plugins) to the included element.
/// @param included A `<model>`, `<light>` or `<actor>`.
/// @param context Context of the file with the `<include>`.
void applyOverrides(const Element& include, Element& included, Context& context);

}  // namespace pongsim::sdf
