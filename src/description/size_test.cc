#include "description/size.hh"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace pongsim::description {
namespace {

using Size = std::vector<double>;

TEST(SizeOf, HasTheNumbersOfSimpleShapes) {
  EXPECT_EQ(sizeOf(Box{{1, 2, 3}}), Size({1, 2, 3}));
  EXPECT_EQ(sizeOf(Sphere{4}), Size({4}));
  EXPECT_EQ(sizeOf(Cylinder{5, 6}), Size({5, 6}));
  EXPECT_EQ(sizeOf(Capsule{7, 8}), Size({7, 8}));
  EXPECT_EQ(sizeOf(Ellipsoid{{9, 10, 11}}), Size({9, 10, 11}));
  for (const Geometry& other : {Geometry(Empty()), Geometry(Plane()), Geometry(Mesh()), Geometry(Cone())}) {
    EXPECT_EQ(sizeOf(other), Size());
  }
}

TEST(SetSize, ChangesTheShape) {
  Geometry shape = Capsule{1, 2};
  setSize(shape, std::array{3.0, 4.0});
  EXPECT_EQ(shape, Geometry(Capsule{3, 4}));
  shape = Ellipsoid{{1, 2, 3}};
  setSize(shape, std::array{4.0, 5.0, 6.0});
  EXPECT_EQ(shape, Geometry(Ellipsoid{{4, 5, 6}}));
}

}  // namespace
}  // namespace pongsim::description
