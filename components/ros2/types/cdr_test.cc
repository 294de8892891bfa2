#include "ros2/types/cdr.hh"

#include <gtest/gtest.h>

#include <cstring>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {
namespace {

sensor_msgs::LaserScan someScan() {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = {3, 500};
  scan.header.frame_id = "base/lidar";
  scan.angle_min = -1.5F;
  scan.ranges = {1, 2, 3.25F};
  return scan;
}

TEST(Cdr, GivesBackWhatWasWritten) {
  const auto bytes = toCdr(someScan());
  sensor_msgs::LaserScan read;
  EXPECT_EQ(readCdr(bytes, read), std::nullopt);
  EXPECT_EQ(read, someScan());
}

TEST(Cdr, WritesAnEmptyTypeAsOneByte) { EXPECT_EQ(toCdr(std_msgs::Empty()).size(), kEncapsulation + 1); }

TEST(Cdr, RefusesEveryPayloadThatIsCutOff) {
  const auto bytes = toCdr(someScan());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    sensor_msgs::LaserScan read;
    EXPECT_NE(readCdr(std::span(bytes).first(size), read), std::nullopt) << size;
  }
}

TEST(Cdr, RefusesASequenceThatClaimsMoreThanThereIs) {
  auto bytes = toCdr(someScan());
  const std::uint32_t many = 4'000'000'000;
  // after the encapsulation: stamp 8, text 4 + 11, seven floats from 24 on
  std::memcpy(&bytes[kEncapsulation + 52], &many, sizeof many);
  sensor_msgs::LaserScan read;
  EXPECT_EQ(readCdr(bytes, read), "field 'ranges' claims 4000000000 elements, but 16 bytes are left");
  EXPECT_LT(read.ranges.capacity(), 100U);
}

TEST(Cdr, RefusesATextWithoutAnEnd) {
  auto bytes = toCdr(std_msgs::String{"hello"});
  bytes.back() = std::byte('!');
  std_msgs::String read;
  EXPECT_EQ(readCdr(bytes, read), "field 'data' is a string without an end");
}

TEST(Cdr, ReadsTheOtherByteOrder) {
  const unsigned char bytes[] = {0, 0, 0, 0, 0x3f, 0xf0, 0, 0, 0, 0, 0, 0, 0x40, 0,
                                 0, 0, 0, 0, 0,    0,    0, 0, 0, 0, 0, 0, 0,    0};
  geometry_msgs::Vector3 read;
  EXPECT_EQ(readCdr(std::as_bytes(std::span(bytes)), read), std::nullopt);
  EXPECT_EQ(read, (geometry_msgs::Vector3{1, 2, 0}));
}

TEST(Cdr, WritesBulkBytesToTheirPlace) {
  sensor_msgs::BasicImage<BulkBytes> image;
  image.encoding = "mono8";
  image.data = {3, [](std::span<std::byte> place) { std::ranges::fill(place, std::byte(7)); }};
  sensor_msgs::Image read;
  EXPECT_EQ(readCdr(toCdr(image), read), std::nullopt);
  EXPECT_EQ(read.encoding, "mono8");
  EXPECT_EQ(read.data, (std::vector<std::uint8_t>{7, 7, 7}));
}

}  // namespace
}  // namespace pongsim::ros2
