#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Applies the overrides in an `<include>` (name, pose, static, placement_frame, plugins) to the included element.
/// @param included A `<model>`, `<light>` or `<actor>`.
/// @param context Context of the file with the `<include>`.
void applyOverrides(const Element& include, Element& included, Context& context);

/// Applies what an `<include>` of a file says to the `<include>` that is all of that file: its own overrides count.
void joinOverrides(const Element& outer, Element& inner);

}  // namespace pongsim::sdf
