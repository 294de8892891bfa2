#pragma once

#include <cstdint>
#include <string>

#include "pongsim/types.hh"

namespace pongsim {

// Functions that put values of pongsim into fields of messages. Templates, so that this header needs no message types.

/// @param message An ignition.msgs.Vector3d.
template <class Message>
void setVector(const Vector3& vector, Message& message) {
  message.set_x(vector.x());
  message.set_y(vector.y());
  message.set_z(vector.z());
}

/// @param message An ignition.msgs.Quaternion.
template <class Message>
void setRotation(const Quaternion& rotation, Message& message) {
  message.set_x(rotation.x());
  message.set_y(rotation.y());
  message.set_z(rotation.z());
  message.set_w(rotation.w());
}

/// @param message An ignition.msgs.Pose.
template <class Message>
void setPose(const Pose& pose, Message& message) {
  setVector(pose.position, *message.mutable_position());
  setRotation(pose.rotation, *message.mutable_orientation());
}

/// @param message An ignition.msgs.Time.
template <class Message>
void setTime(Time time, Message& message) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  message.set_sec(seconds.count());
  message.set_nsec(static_cast<std::int32_t>((time - seconds).count()));
}

/// @param header An ignition.msgs.Header.
template <class Header>
void setStamp(Time time, Header& header) {
  setTime(time, *header.mutable_stamp());
}

/// Sets the value of a key in a header's data, such as "frame_id".
/// @param header An ignition.msgs.Header.
template <class Header>
void setHeaderValue(const std::string& key, const std::string& value, Header& header) {
  for (auto& entry : *header.mutable_data()) {
    if (entry.key() != key) continue;
    entry.set_value(0, value);
    return;
  }
  auto& entry = *header.add_data();
  entry.set_key(key);
  entry.add_value(value);
}

}  // namespace pongsim
