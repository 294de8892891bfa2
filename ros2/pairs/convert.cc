#include "ros2/pairs/convert.hh"

#include <chrono>

#include "pongsim/fields.hh"

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

void convert(const ignition::msgs::Vector3d& from, geometry_msgs::Vector3& to) { to = {from.x(), from.y(), from.z()}; }

void convert(const geometry_msgs::Vector3& from, ignition::msgs::Vector3d& to) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_z(from.z);
}

}  // namespace pongsim::ros2
