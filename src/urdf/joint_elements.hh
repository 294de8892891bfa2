#pragma once

#include "pongsim/element.hh"
#include "urdf/extensions.hh"
#include "urdf/robot.hh"

namespace pongsim::urdf {

/// Adds the `<joint>` between a link and its parent to the model; none if the joint leaves the link free. Warns about
/// settings that are not simulated.
void addJoint(const Robot& robot, const Link& link, const Extensions& extensions, Element& model,
              Diagnostics& diagnostics);

}  // namespace pongsim::urdf
