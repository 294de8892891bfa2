#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Brings a file to SDF 1.9, so that readers know that version only. What it held that 1.9 has no place for goes, with
/// a warning where it meant something.
/// @param root The `<sdf>` element, of version 1.`context.version`.
void upgrade(Element& root, Context& context);

}  // namespace pongsim::sdf
