#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Puts what an `<include>` says (name, pose, static, placement_frame, plugins) in place of what the included element
/// says itself.
/// @param included A `<model>`, `<light>` or `<actor>`.
/// @param context That of the file of the `<include>`.
void applyOverrides(const Element& include, Element& included, Context& context);

}  // namespace pongsim::sdf
