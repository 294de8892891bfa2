#include "cli/dataset/kitti.hh"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace pongsim::cli {
namespace {

Sample with(LabelledThing thing) { return {"p.png", 200, 100, {std::move(thing)}}; }

/// A box in a camera's frame as users know it (x ahead, y to the left, z up), which is 10 m ahead.
BoxInSpace ahead(double yaw, const Vector3& place = {10, 0, 0}) {
  Matrix3 axes;
  axes << 0, -1, 0, 0, 0, 1, -1, 0, 0;
  const Quaternion turn(axes);
  return {{turn * place, turn * fromRollPitchYaw(0, 0, yaw)}, {4, 2, 1}};
}

TEST(Kitti, SaysWhatIsUnknownOfBoxesInThePicture) {
  EXPECT_EQ(kittiLabels(with({.label = 7, .box = {Eigen::Vector2d(1, 2), Eigen::Vector2d(4, 8)}}), 0, {{7, "big car"}}),
            "big_car -1.00 3 -10.00 1.00 2.00 3.00 7.00 -1.00 -1.00 -1.00 -1000.00 -1000.00 -1000.00 -10.00\n");
}

TEST(Kitti, PlacesBoxesInSpace) {
  // its length is across the line of sight, to the left; the nearest side is 9 m away
  const Sample sample = with({.label = 7, .space = ahead(std::numbers::pi / 2)});
  // 90 / 9 * (4 / 2) = 20 pixels to each side, 90 / 9 * (1 / 2) = 5 up and down
  const std::string line = kittiLabels(sample, 90, {});
  EXPECT_TRUE(line.starts_with("label_7 0.00 3 ")) << line;
  EXPECT_NE(line.find(" 80.00 45.00 119.00 54.00 1.00 2.00 4.00 0.00 0.50 10.00 "), std::string::npos) << line;
  // half a turn, to either side
  EXPECT_TRUE(line.ends_with("3.14\n")) << line;
}

TEST(Kitti, HasTheRotationAroundTheDownwardAxis) {
  // ahead is -90 degrees; as seen from the camera, half a right angle less to the right
  const Sample sample = with({.label = 7, .space = ahead(0, {10, -10, 0})});
  const std::string line = kittiLabels(sample, 20, {});
  EXPECT_NE(line.find(" 1.00 2.00 4.00 10.00 0.50 10.00 -1.57\n"), std::string::npos) << line;
  EXPECT_TRUE(line.starts_with("label_7 0.00 3 -2.36 ")) << line;
}

TEST(Kitti, CutsAtTheEdgesOfThePicture) {
  const std::string line = kittiLabels(with({.label = 7, .space = ahead(std::numbers::pi / 2, {10, 10, 0})}), 90, {});
  // from 12 / 9 to 8 / 11 to the left: 100 - 120 to 100 - 65.45 pixels, of 54.55 pixels 34.55 are seen
  EXPECT_TRUE(line.starts_with("label_7 0.37 3 ")) << line;
  EXPECT_NE(line.find(" 0.00 45.00 33.55 54.00 "), std::string::npos) << line;
}

TEST(Kitti, LeavesOutWhatIsBehindTheCamera) {
  EXPECT_EQ(kittiLabels(with({.label = 7, .space = ahead(0, {-10, 0, 0})}), 90, {}), "");
}

TEST(Kitti, HasTheProjectionOfTheCamera) {
  const std::string text = kittiCalibration(with({}), 90);
  EXPECT_NE(
      text.find("P2: 9.000000000000e+01 0 1.000000000000e+02 0 0 9.000000000000e+01 5.000000000000e+01 0 0 0 1 0\n"),
      std::string::npos)
      << text;
}

}  // namespace
}  // namespace pongsim::cli
