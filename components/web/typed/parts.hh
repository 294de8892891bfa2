#pragma once

#include <foxglove/basics.pb.h>
#include <google/protobuf/timestamp.pb.h>
#include <ignition/msgs/color.pb.h>
#include <ignition/msgs/header.pb.h>
#include <ignition/msgs/pose.pb.h>

#include <cstdint>
#include <string>

/// Conversions of the parts of messages.
namespace pongsim::web::typed {

inline void fillIn(double x, double y, double z, ::foxglove::Vector3& out) {
  out.set_x(x);
  out.set_y(y);
  out.set_z(z);
}

inline void fillIn(const ignition::msgs::Quaternion& in, ::foxglove::Quaternion& out) {
  out.set_x(in.x());
  out.set_y(in.y());
  out.set_z(in.z());
  // a missing rotation is the identity
  const bool isNone = in.x() == 0 && in.y() == 0 && in.z() == 0 && in.w() == 0;
  out.set_w(isNone ? 1 : in.w());
}

inline void fillIn(const ignition::msgs::Pose& in, ::foxglove::Pose& out) {
  fillIn(in.position().x(), in.position().y(), in.position().z(), *out.mutable_position());
  fillIn(in.orientation(), *out.mutable_orientation());
}

inline void fillIn(std::uint64_t timeNs, google::protobuf::Timestamp& out) {
  out.set_seconds(static_cast<std::int64_t>(timeNs / 1'000'000'000));
  out.set_nanos(static_cast<std::int32_t>(timeNs % 1'000'000'000));
}

/// @param timeNs Used if the header has no time.
inline void fillIn(const ignition::msgs::Header& header, std::uint64_t timeNs, google::protobuf::Timestamp& out) {
  if (!header.has_stamp()) return fillIn(timeNs, out);
  out.set_seconds(header.stamp().sec());
  out.set_nanos(header.stamp().nsec());
}

/// @return The frame in the header, or an empty text.
inline std::string frameOf(const ignition::msgs::Header& header) {
  for (const auto& entry : header.data()) {
    if (entry.key() == "frame_id" && entry.value_size() > 0) return entry.value(0);
  }
  return {};
}

}  // namespace pongsim::web::typed
