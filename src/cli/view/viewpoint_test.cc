#include "cli/view/viewpoint.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pongsim::cli {
namespace {

TEST(Viewpoint, IsAPoseOrAPlaceThatLooksAtTheOrigin) {
  const std::optional<Pose> pose = readViewpoint("1 -2 3 0.1 0.2 0.3");
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->position, Vector3(1, -2, 3));
  EXPECT_TRUE(pose->rotation.isApprox(fromRollPitchYaw(0.1, 0.2, 0.3)));
  const std::optional<Pose> place = readViewpoint("3 4 5");
  ASSERT_TRUE(place);
  EXPECT_TRUE((place->rotation * Vector3::UnitX()).isApprox(-Vector3(3, 4, 5).normalized()));
  for (const char* text : {"", "box", "1 2", "1 2 3 4", "1 2 nan", "1 2 3x", "1 2 3 4 5 6 7"}) {
    EXPECT_FALSE(readViewpoint(text)) << text;
  }
}

TEST(Viewpoint, LetsABoxFillThePicture) {
  for (const Vector3& size : {Vector3(1, 1, 1), Vector3(40, 3, 0.1), Vector3(0, 0, 0)}) {
    PictureView view;
    const Eigen::AlignedBox3d box(Vector3(5, 6, 7) - size / 2, Vector3(5, 6, 7) + size / 2);
    lookAt(box, view);
    double farthest = 0;
    for (int i = 0; i < 8; ++i) {
      const Vector3 corner = view.X_WorldEye.inverse() * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
      ASSERT_GT(corner.x(), 0);
      farthest = std::max({farthest, std::abs(view.fx * corner.y() / corner.x()) / view.cx,
                           std::abs(view.fy * corner.z() / corner.x()) / view.cy});
    }
    EXPECT_LT(farthest, 1);
    if (size.norm() > 0) {
      EXPECT_GT(farthest, 0.8);
    }
  }
}

}  // namespace
}  // namespace pongsim::cli
