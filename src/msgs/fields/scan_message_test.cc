#include "msgs/fields/scan_message.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::msgs {
namespace {

struct RowCase {
  const char* text;
  std::vector<double> ranges;
  double elevation;
};

TEST(LevelRow, IsTheOneNearestToTheHorizon) {
  const RowCase cases[] = {
      {"", {}, 0},
      {"ranges: [1, 2]", {1, 2}, 0},
      {"count: 2, ranges: [1, 2]", {1, 2}, 0},
      {"count: 2, vertical_count: 3, vertical_angle_min: -0.3, vertical_angle_step: 0.2, ranges: [1, 2, 3, 4, 5, 6]",
       {3, 4},
       -0.1},
      {"count: 1, vertical_count: 1, vertical_angle_step: nan, ranges: 7", {7}, 0},
      // fewer ranges than `count`
      {"count: 9, vertical_count: 9, vertical_angle_min: -1, vertical_angle_step: 0.1, ranges: [1, 2]", {1, 2}, -1},
      {"count: 2, vertical_count: 9, vertical_angle_min: 1, vertical_angle_step: -0.1, ranges: [1, 2, 3, 4, 5]",
       {3, 4},
       0.9},
  };
  for (const RowCase& each : cases) {
    const MessagePointer scan = newMessage("ignition.msgs.LaserScan");
    ASSERT_FALSE(parseMessage(each.text, *scan)) << each.text;
    const ScanRow row = levelRowOf(*scan);
    EXPECT_EQ(std::vector<double>(row.ranges.begin(), row.ranges.end()), each.ranges) << each.text;
    EXPECT_NEAR(row.elevation, each.elevation, 1e-12) << each.text;
  }
}

TEST(LevelRow, KnowsItsTimeAndItsAngles) {
  const MessagePointer scan = newMessage("ignition.msgs.LaserScan");
  ASSERT_FALSE(
      parseMessage("header { stamp { sec: 2, nsec: 500000000 } } angle_min: -1, angle_step: 0.5, ranges: 3", *scan));
  const ScanRow row = levelRowOf(*scan);
  EXPECT_EQ(toSeconds(row.time), 2.5);
  EXPECT_EQ(row.firstAngle, -1);
  EXPECT_EQ(row.angleStep, 0.5);
}

}  // namespace
}  // namespace pongsim::msgs
