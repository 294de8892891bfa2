#include "msgs/scan_message.hh"

#include <ignition/msgs/laserscan.pb.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pongsim::msgs {

ScanRow levelRowOf(const Message& scan) {
  const auto& message = static_cast<const ignition::msgs::LaserScan&>(scan);
  ScanRow row;
  row.time =
      std::chrono::seconds(message.header().stamp().sec()) + std::chrono::nanoseconds(message.header().stamp().nsec());
  row.firstAngle = message.angle_min();
  row.angleStep = message.angle_step();
  const auto size = static_cast<std::size_t>(message.ranges_size());
  const std::size_t count = message.count() > 0 ? std::min<std::size_t>(message.count(), size) : size;
  if (count == 0) return row;

  // rows that are there
  const std::size_t rows = std::clamp<std::size_t>(message.vertical_count(), 1, size / count);
  const auto elevationOf = [&message](std::size_t index) {
    return index == 0 ? message.vertical_angle_min()
                      : message.vertical_angle_min() + static_cast<double>(index) * message.vertical_angle_step();
  };
  std::size_t level = 0;
  for (std::size_t index = 1; index < rows; ++index) {
    if (std::abs(elevationOf(index)) < std::abs(elevationOf(level))) level = index;
  }
  row.elevation = elevationOf(level);
  row.ranges = {message.ranges().data() + level * count, count};
  return row;
}

}  // namespace pongsim::msgs
