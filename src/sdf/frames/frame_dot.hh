#pragma once

#include <string>

#include "sdf/frames/scope.hh"

namespace pongsim::sdf {

enum class FrameGraphKind {
  /// Which link each frame moves with: an arrow from a frame to what it is attached to.
  kFrame,
  /// Where each frame is: an arrow to it from the frame that its pose is relative to, labelled x y z roll pitch yaw.
  kPose,
};

/// @return The frames of a resolved scope and of the scopes inside it, as text for Graphviz.
std::string frameDot(const Scope& scope, FrameGraphKind kind);

}  // namespace pongsim::sdf
