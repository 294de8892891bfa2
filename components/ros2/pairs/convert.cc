#include "ros2/pairs/convert.hh"

#include <chrono>

#include "pongsim/messages/fields.hh"

namespace pongsim::ros2 {

void convert(const ignition::msgs::Time& from, builtin_interfaces::Time& to) {
  to.sec = static_cast<std::int32_t>(from.sec());
  to.nanosec = static_cast<std::uint32_t>(from.nsec());
}

void convert(const builtin_interfaces::Time& from, ignition::msgs::Time& to) {
  to.set_sec(from.sec);
  to.set_nsec(static_cast<std::int32_t>(from.nanosec));
}

void convert(const ignition::msgs::Header& from, std_msgs::Header& to, const Frames& frames) {
  if (frames.usesWallTime) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
    to.stamp.sec = static_cast<std::int32_t>(seconds.count());
    to.stamp.nanosec = static_cast<std::uint32_t>(std::chrono::nanoseconds(now - seconds).count());
  } else {
    convert(from.stamp(), to.stamp);
  }
  to.frame_id.clear();
  for (const auto& entry : from.data()) {
    if (entry.key() == "frame_id" && entry.value_size() > 0) frames.toRos(entry.value(0), to.frame_id);
  }
}

void convert(const std_msgs::Header& from, ignition::msgs::Header& to, const Frames& frames) {
  convert(from.stamp, *to.mutable_stamp());
  to.clear_data();
  auto* entry = to.add_data();
  entry->set_key("frame_id");
  entry->add_value(std::string(frames.fromRos(from.frame_id)));
}

void childFrame(const ignition::msgs::Header& from, std::string& to, const Frames& frames) {
  to.clear();
  for (const auto& entry : from.data()) {
    if (entry.key() == "child_frame_id" && entry.value_size() > 0) frames.toRos(entry.value(0), to);
  }
}

void addChildFrame(const std::string& from, ignition::msgs::Header& to, const Frames& frames) {
  auto* entry = to.add_data();
  entry->set_key("child_frame_id");
  entry->add_value(std::string(frames.fromRos(from)));
}

void convert(const ignition::msgs::Vector3d& from, geometry_msgs::Vector3& to) { to = {from.x(), from.y(), from.z()}; }

void convert(const geometry_msgs::Vector3& from, ignition::msgs::Vector3d& to) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_z(from.z);
}

void convert(const ignition::msgs::Vector3d& from, geometry_msgs::Point& to) { to = {from.x(), from.y(), from.z()}; }

void convert(const geometry_msgs::Point& from, ignition::msgs::Vector3d& to) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_z(from.z);
}

void convert(const ignition::msgs::Quaternion& from, geometry_msgs::Quaternion& to) {
  const bool isSet = from.x() != 0 || from.y() != 0 || from.z() != 0 || from.w() != 0;
  to = {from.x(), from.y(), from.z(), isSet ? from.w() : 1};
}

void convert(const geometry_msgs::Quaternion& from, ignition::msgs::Quaternion& to) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_z(from.z);
  to.set_w(from.w);
}

void convert(const ignition::msgs::Pose& from, geometry_msgs::Pose& to) {
  convert(from.position(), to.position);
  convert(from.orientation(), to.orientation);
}

void convert(const geometry_msgs::Pose& from, ignition::msgs::Pose& to) {
  convert(from.position, *to.mutable_position());
  convert(from.orientation, *to.mutable_orientation());
}

void convert(const ignition::msgs::Pose& from, geometry_msgs::Transform& to) {
  convert(from.position(), to.translation);
  convert(from.orientation(), to.rotation);
}

void convert(const geometry_msgs::Transform& from, ignition::msgs::Pose& to) {
  convert(from.translation, *to.mutable_position());
  convert(from.rotation, *to.mutable_orientation());
}

void convert(const ignition::msgs::Pose& from, geometry_msgs::TransformStamped& to, const Frames& frames) {
  convert(from.header(), to.header, frames);
  childFrame(from.header(), to.child_frame_id, frames);
  convert(from, to.transform);
}

void convert(const geometry_msgs::TransformStamped& from, ignition::msgs::Pose& to, const Frames& frames) {
  convert(from.header, *to.mutable_header(), frames);
  addChildFrame(from.child_frame_id, *to.mutable_header(), frames);
  convert(from.transform, to);
}

void convert(const ignition::msgs::Twist& from, geometry_msgs::Twist& to) {
  convert(from.linear(), to.linear);
  convert(from.angular(), to.angular);
}

void convert(const geometry_msgs::Twist& from, ignition::msgs::Twist& to) {
  convert(from.linear, *to.mutable_linear());
  convert(from.angular, *to.mutable_angular());
}

void convert(const ignition::msgs::Wrench& from, geometry_msgs::Wrench& to) {
  convert(from.force(), to.force);
  convert(from.torque(), to.torque);
}

void convert(const geometry_msgs::Wrench& from, ignition::msgs::Wrench& to) {
  convert(from.force, *to.mutable_force());
  convert(from.torque, *to.mutable_torque());
}

void convert(const ignition::msgs::Color& from, std_msgs::ColorRGBA& to) {
  to = {from.r(), from.g(), from.b(), from.a()};
}

void convert(const std_msgs::ColorRGBA& from, ignition::msgs::Color& to) {
  to.set_r(from.r);
  to.set_g(from.g);
  to.set_b(from.b);
  to.set_a(from.a);
}

}  // namespace pongsim::ros2
