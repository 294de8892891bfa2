#pragma once

#include "pongsim/element.hh"
#include "urdf/extensions.hh"
#include "urdf/robot.hh"

namespace pongsim::urdf {

/// Adds a `<link>` to the model, with everything that has become part of it.
void addLink(const Robot& robot, const Link& link, const Extensions& extensions, Element& model);

/// Adds two `<frame>`s to the model for a link that has become part of another: one for its joint, and one for the
/// link. Names that the robot's `<gazebo>` gives to elements of its own are left to these.
void addFrames(const Robot& robot, const Link& link, const Extensions& extensions, Element& model);

}  // namespace pongsim::urdf
