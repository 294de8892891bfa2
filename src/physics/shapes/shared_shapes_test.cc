#include "physics/shapes/shared_shapes.hh"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace pongsim::physics {
namespace {

TEST(SharedShapes, GivesTheSameForTheSame) {
  SharedShapes shared;
  description::Surface rough;
  rough.mu = 2;
  const auto one = shared.surface(rough);
  EXPECT_EQ(*one, rough);
  EXPECT_EQ(one, shared.surface(rough));
  const auto shape = shared.shape(description::Box{{1, 2, 3}}, *one, 4);
  EXPECT_EQ(shape, shared.shape(description::Box{{1, 2, 3}}, *one, 4));
  EXPECT_EQ(shape->getUserPointer(), one.get());
  EXPECT_EQ(shape->getUserIndex(), 4);
}

TEST(SharedShapes, GivesOthersForOthers) {
  SharedShapes shared;
  description::Surface rough, named;
  rough.mu = 2;
  // which the hash does not look at
  named.fdir1Link = "chassis";
  const auto plain = shared.surface({});
  EXPECT_NE(plain, shared.surface(rough));
  EXPECT_NE(plain, shared.surface(named));
  const auto other = shared.surface(named);
  const auto box = shared.shape(description::Box{{1, 2, 3}}, *plain, 0);
  EXPECT_NE(box, shared.shape(description::Box{{1, 2, 4}}, *plain, 0));
  EXPECT_NE(box, shared.shape(description::Ellipsoid{{1, 2, 3}}, *plain, 0));
  EXPECT_NE(box, shared.shape(description::Box{{1, 2, 3}}, *other, 0));
  EXPECT_NE(box, shared.shape(description::Box{{1, 2, 3}}, *plain, 1));
}

TEST(SharedShapes, HasNoneOfTriangles) {
  SharedShapes shared;
  const auto surface = shared.surface({});
  EXPECT_EQ(shared.shape(description::Mesh{}, *surface, 0), nullptr);
  EXPECT_EQ(shared.shape(description::Empty{}, *surface, 0), nullptr);
}

TEST(SharedShapes, ForgetsWhatNobodyHas) {
  SharedShapes shared;
  const auto surface = shared.surface({});
  std::vector<std::shared_ptr<btCollisionShape>> kept;
  for (int i = 1; i <= 10'000; ++i) {
    const auto shape = shared.shape(description::Sphere{0.001 * i}, *surface, 0);
    if (i <= 100) kept.push_back(shape);
  }
  EXPECT_LT(shared.size(), 500U);
  EXPECT_EQ(kept.front(), shared.shape(description::Sphere{0.001}, *surface, 0));
}

}  // namespace
}  // namespace pongsim::physics
