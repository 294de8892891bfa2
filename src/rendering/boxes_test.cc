#include "rendering/boxes.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/rendering/drawn_world.hh"

namespace pongsim::rendering {
namespace {

using test::DrawnWorld;
using test::Pictures;
using test::view;

TEST_F(Pictures, BoundVisualsByTheirProjection) {
  DrawnWorld world;
  world.addShining(description::Box{{2, 2, 4}}, {6, 1, 0}, {});
  world.addShining(description::Sphere{1}, {5, 0, 0}, {});
  world.start();
  const PictureView eye = view(64, 48, 50);
  // the nearer face, 5 m ahead
  Eigen::AlignedBox2d box = imageBounds(world.scene(), 0, eye);
  EXPECT_NEAR(box.min().x(), 32 - 50 * 2 / 5.0, 1e-6);
  EXPECT_NEAR(box.max().x(), 32, 1e-6);
  EXPECT_NEAR(box.min().y(), 24 - 50 * 2 / 5.0, 1e-6);
  EXPECT_NEAR(box.max().y(), 24 + 50 * 2 / 5.0, 1e-6);
  // the cone around a ball has the tangent 1 / sqrt(5^2 - 1); its triangles are within 0.3 % of it
  box = imageBounds(world.scene(), 1, eye);
  EXPECT_NEAR(box.sizes().x(), 100 / std::sqrt(24), 0.1);
  EXPECT_NEAR(box.sizes().y(), 100 / std::sqrt(24), 0.1);
}

TEST_F(Pictures, BoundOnlyWhatIsBeforeTheNearClipPlane) {
  DrawnWorld world;
  // from 4 m behind the camera to 5 m ahead, to the left of it
  world.addShining(description::Box{{9, 1, 1}}, {0.5, 1, 0}, {});
  world.addShining(description::Box{{1, 1, 1}}, {-3, 0, 0}, {});
  world.start();
  PictureView eye = view(64, 48, 50);
  eye.near = 0.5;
  const Eigen::AlignedBox2d box = imageBounds(world.scene(), 0, eye);
  EXPECT_NEAR(box.min().x(), 32 - 50 * 1.5 / 0.5, 1e-6);
  EXPECT_NEAR(box.max().x(), 32 - 50 * 0.5 / 5, 1e-6);
  EXPECT_NEAR(box.max().y(), 24 + 50 * 0.5 / 0.5, 1e-6);
  EXPECT_TRUE(imageBounds(world.scene(), 1, eye).isEmpty());
}

TEST_F(Pictures, BoundVisualsInSpace) {
  DrawnWorld world;
  world.add(description::Box{{1, 2, 3}}, {{5, 0, 1}, fromRollPitchYaw(0.1, 0.2, 0.3)});
  world.add(description::Sphere{0.5}, {{0, 0, 0}, Quaternion::Identity()});
  world.add(description::Sphere{0.5}, {{4, 4, 0}, Quaternion::Identity()});
  world.start();
  const std::vector<std::size_t> one{0}, both{1, 2};
  const TurnedBox box = turnedBox(world.scene(), one);
  EXPECT_TRUE(box.pose.position.isApprox(Vector3(5, 0, 1), 1e-9));
  EXPECT_LT(box.pose.rotation.angularDistance(fromRollPitchYaw(0.1, 0.2, 0.3)), 1e-6);
  EXPECT_TRUE(box.size.isApprox(Vector3(1, 2, 3), 1e-6));
  // two balls: the box lies along the line between them
  const TurnedBox around = turnedBox(world.scene(), both);
  EXPECT_TRUE(around.pose.position.isApprox(Vector3(2, 2, 0), 0.01)) << around.pose.position.transpose();
  EXPECT_NEAR(around.size.maxCoeff(), std::sqrt(32) + 1, 0.01);
  EXPECT_NEAR(around.size.minCoeff(), 1, 0.01);
  int longest = 0;
  around.size.maxCoeff(&longest);
  const Vector3 along = around.pose.rotation * Vector3::Unit(longest);
  EXPECT_NEAR(std::abs(along.dot(Vector3(1, 1, 0).normalized())), 1, 1e-3);
}

}  // namespace
}  // namespace pongsim::rendering
