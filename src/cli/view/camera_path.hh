#pragma once

#include <optional>
#include <string>

#include "cli/view/sight.hh"
#include "pongsim/types.hh"

namespace pongsim::cli {

/// How the camera of a video moves.
class CameraPath {
 public:
  /// @param start Where it is in the first picture.
  /// @param follow What it moves with, without turning; empty: nothing.
  /// @param centre What it turns around once, anticlockwise seen from above; nothing: it does not turn.
  CameraPath(Sight& sight, const Pose& start, std::string follow, const std::optional<Vector3>& centre);

  /// @param share How much of the video has passed, 0 to 1.
  /// @return Where it is now. Where what it follows is gone, it stays with the last position.
  Pose at(double share);

 private:
  Sight& sight_;
  Pose start_;
  std::string follow_;
  std::optional<Vector3> centre_;
  /// Of what it follows, in the first picture.
  Vector3 first_ = Vector3::Zero();
  Vector3 moved_ = Vector3::Zero();
};

}  // namespace pongsim::cli
