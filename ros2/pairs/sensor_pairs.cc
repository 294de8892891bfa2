// sensor_msgs
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>

#include <algorithm>
#include <iterator>

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {

namespace {

struct LaserScanPair {
  using Ros = sensor_msgs::LaserScan;
  using Ignition = ignition::msgs::LaserScan;
  static void convert(const Ignition& from, Ros& to, const Frames& frames);
  static void convert(const Ros& from, Ignition& to, const Frames& frames);
};

void LaserScanPair::convert(const Ignition& from, Ros& to, const Frames& frames) {
  ros2::convert(from.header(), to.header, frames);
  frames.toRos(from.frame(), to.header.frame_id);
  to.angle_min = static_cast<float>(from.angle_min());
  to.angle_max = static_cast<float>(from.angle_max());
  to.angle_increment = static_cast<float>(from.angle_step());
  to.range_min = static_cast<float>(from.range_min());
  to.range_max = static_cast<float>(from.range_max());
  // of several rows the one in the middle, as ros_gz does
  const auto count = static_cast<int>(from.count());
  const int begin = static_cast<int>(from.vertical_count() / 2) * count;
  const auto copyRow = [&](const auto& all, std::vector<float>& row) {
    row.clear();
    const int end = std::min(begin + count, all.size());
    for (int i = begin; i < end; ++i) row.push_back(static_cast<float>(all.Get(i)));
  };
  copyRow(from.ranges(), to.ranges);
  copyRow(from.intensities(), to.intensities);
}

void LaserScanPair::convert(const Ros& from, Ignition& to, const Frames& frames) {
  ros2::convert(from.header, *to.mutable_header(), frames);
  to.set_frame(std::string(frames.fromRos(from.header.frame_id)));
  to.set_angle_min(static_cast<double>(from.angle_min));
  to.set_angle_max(static_cast<double>(from.angle_max));
  to.set_angle_step(static_cast<double>(from.angle_increment));
  to.set_range_min(static_cast<double>(from.range_min));
  to.set_range_max(static_cast<double>(from.range_max));
  to.set_count(static_cast<std::uint32_t>(from.ranges.size()));
  to.mutable_ranges()->Assign(from.ranges.begin(), from.ranges.end());
  to.mutable_intensities()->Assign(from.intensities.begin(), from.intensities.end());
}

/// How both sides name formats of pixels, and their bytes a pixel.
struct ImageFormat {
  ignition::msgs::PixelFormatType type;
  std::string_view encoding;
  std::uint32_t bytes;
};
constexpr ImageFormat kImageFormats[] = {
    {ignition::msgs::L_INT8, "mono8", 1},    {ignition::msgs::L_INT16, "mono16", 2},
    {ignition::msgs::RGB_INT8, "rgb8", 3},   {ignition::msgs::RGBA_INT8, "rgba8", 4},
    {ignition::msgs::BGRA_INT8, "bgra8", 4}, {ignition::msgs::RGB_INT16, "rgb16", 6},
    {ignition::msgs::BGR_INT8, "bgr8", 3},   {ignition::msgs::BGR_INT16, "bgr16", 6},
    {ignition::msgs::R_FLOAT32, "32FC1", 4},
};

struct ImagePair {
  using Ros = sensor_msgs::Image;
  using RosOut = sensor_msgs::BasicImage<BulkBytes>;
  using Ignition = ignition::msgs::Image;

  static void convert(const Ignition& from, RosOut& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.height = from.height();
    to.width = from.width();
    const auto* format = std::ranges::find(kImageFormats, from.pixel_format_type(), &ImageFormat::type);
    const bool isKnown = format != std::end(kImageFormats);
    to.encoding = isKnown ? format->encoding : std::string_view();
    to.is_bigendian = 0;
    to.step = isKnown ? to.width * format->bytes : from.step();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_width(from.width);
    to.set_height(from.height);
    to.set_step(from.step);
    const auto* format = std::ranges::find(kImageFormats, from.encoding, &ImageFormat::encoding);
    to.set_pixel_format_type(format != std::end(kImageFormats) ? format->type : ignition::msgs::UNKNOWN_PIXEL_FORMAT);
    to.set_data(from.data.data(), from.data.size());
  }
};

}  // namespace

std::vector<Pair> sensorPairs() {
  return {pairOf<LaserScanPair>(Choice::kDefault), pairOf<ImagePair>(Choice::kDefault)};
}

}  // namespace pongsim::ros2
