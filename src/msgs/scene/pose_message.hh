#pragma once

#include "pongsim/types.hh"

namespace pongsim::msgs {

/// @param message An ignition.msgs.Vector3d.
template <class Message>
Vector3 vectorFrom(const Message& message) {
  return {message.x(), message.y(), message.z()};
}

/// @param message An ignition.msgs.Pose; without an orientation there is no rotation.
template <class Message>
Pose poseFrom(const Message& message) {
  Pose pose;
  pose.position = vectorFrom(message.position());
  if (message.has_orientation()) {
    const auto& rotation = message.orientation();
    pose.rotation = Quaternion(rotation.w(), rotation.x(), rotation.y(), rotation.z());
  }
  return pose;
}

}  // namespace pongsim::msgs
