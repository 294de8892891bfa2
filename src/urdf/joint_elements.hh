#pragma once

#include "pongsim/element.hh"
#include "urdf/extensions.hh"
#include "urdf/robot.hh"

namespace pongsim::urdf {

/// Adds the `<joint>` between a link and its parent to the model; nothing where it leaves the link free. Warns of what
/// it says and is not simulated.
void addJoint(const Robot& robot, const Link& link, const Extensions& extensions, Element& model,
              Diagnostics& diagnostics);

}  // namespace pongsim::urdf
