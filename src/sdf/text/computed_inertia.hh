#pragma once

#include "pongsim/element.hh"
#include "sdf/loader.hh"

namespace pongsim::sdf {

/// Writes mass, centre of mass and moments into each `<inertial auto="true">`: the values computed from the link's
/// collisions. The attribute stays.
/// @param root The `<sdf>` element of a resolved file, with the content of includes.
/// @param loaded The same file, without errors.
void writeComputedInertia(Element& root, const Root& loaded);

}  // namespace pongsim::sdf
