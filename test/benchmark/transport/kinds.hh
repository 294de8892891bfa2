#pragma once

#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "calls.hh"

namespace pongsim::benchmark {

/// A kind of message, its rate [Hz], and the number of messages sent.
struct Kind {
  const char* name;
  double rate;
  int count;
};
inline constexpr Kind kKinds[] = {{"Twist", 1000, 2000},
                                  {"LaserScan, 640 beams", 100, 300},
                                  {"Image, 640x480 RGB", 30, 100},
                                  {"PointCloudPacked, 2 MB", 10, 50},
                                  {"Image, 1920x1080 RGB", 10, 30}};
inline constexpr int kImage = 2;

inline ignition::msgs::Image image(unsigned width, unsigned height) {
  ignition::msgs::Image message;
  message.set_width(width);
  message.set_height(height);
  message.mutable_data()->assign(std::size_t{3} * width * height, 'x');
  return message;
}

inline ignition::msgs::LaserScan scan() {
  ignition::msgs::LaserScan message;
  for (int i = 0; i < 640; ++i) message.add_ranges(1 + 0.01 * i);
  return message;
}

inline ignition::msgs::PointCloudPacked cloud() {
  ignition::msgs::PointCloudPacked message;
  message.mutable_data()->assign(2'000'000, 'x');
  return message;
}

/// Calls `use` with a message of this kind, ready to be sent.
template <class Use>
void withMessage(int kind, Use use) {
  switch (kind) {
    case 0:
      return use(ignition::msgs::Twist());
    case 1:
      return use(scan());
    case 2:
      return use(image(640, 480));
    case 3:
      return use(cloud());
    default:
      return use(image(1920, 1080));
  }
}

/// Sets the time in the message's header to now.
template <class M>
void stamp(M& message) {
  const auto now = Clock::now().time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
  message.mutable_header()->mutable_stamp()->set_sec(seconds.count());
  message.mutable_header()->mutable_stamp()->set_nsec(static_cast<std::int32_t>((now - seconds).count()));
}

/// @return The time since `stamp`.
template <class M>
Microseconds age(const M& message) {
  const auto& time = message.header().stamp();
  return Clock::now().time_since_epoch() - std::chrono::seconds(time.sec()) - std::chrono::nanoseconds(time.nsec());
}

}  // namespace pongsim::benchmark
