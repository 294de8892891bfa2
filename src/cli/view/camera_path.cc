#include "cli/view/camera_path.hh"

#include <numbers>
#include <utility>

namespace pongsim::cli {

CameraPath::CameraPath(Sight& sight, const Pose& start, std::string follow, const std::optional<Vector3>& centre)
    : sight_(sight), start_(start), follow_(std::move(follow)), centre_(centre) {
  if (!follow_.empty()) first_ = sight_.position(follow_).value_or(first_);
}

Pose CameraPath::at(double share) {
  if (!follow_.empty()) {
    if (const std::optional<Vector3> now = sight_.position(follow_)) moved_ = *now - first_;
  }
  Pose pose = start_;
  if (centre_) {
    const Quaternion turn = fromRollPitchYaw(0, 0, 2 * std::numbers::pi * share);
    pose = {*centre_ + turn * (start_.position - *centre_), turn * start_.rotation};
  }
  pose.position += moved_;
  return pose;
}

}  // namespace pongsim::cli
