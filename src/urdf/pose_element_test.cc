#include "urdf/pose_element.hh"

#include <gtest/gtest.h>

namespace pongsim::urdf {
namespace {

TEST(PoseElement, WritesNumbersThatReadAsTheSame) {
  EXPECT_EQ(textOf(0.1), "0.1");
  EXPECT_EQ(textOf(-0.0), "0");
  EXPECT_EQ(std::stod(textOf(1.0 / 3)), 1.0 / 3);
  EXPECT_EQ(textOf(Vector3(1, -2.5, 1e-20)), "1 -2.5 1e-20");
}

TEST(PoseElement, WritesAPoseWithAnglesOnlyWhereItDoesNotTurn) {
  Element parent;
  addPose(parent, {{1, 2, 3}, Quaternion::Identity()}, {}, "frame");
  EXPECT_EQ(parent.children[0].text, "1 2 3 0 0 0");
  EXPECT_EQ(parent.children[0].attributeOr("relative_to", ""), "frame");
  addPose(parent, {{0, 0, 0}, Quaternion(0, 1, 0, 0)}, {});
  EXPECT_EQ(parent.children[1].text, "0 0 0 1 0 0 0");
  EXPECT_EQ(parent.children[1].attributeOr("rotation_format", ""), "quat_xyzw");
  EXPECT_EQ(parent.children[1].attribute("relative_to"), nullptr);
}

}  // namespace
}  // namespace pongsim::urdf
