#include "rendering/marker_parts.hh"

#include <gtest/gtest.h>

namespace pongsim::rendering {
namespace {

using MarkerType = world::Marker::Type;
using Corners = std::vector<std::uint32_t>;

/// @return A box around the parts of a marker, before it is scaled.
Eigen::AlignedBox3d boundsOf(const std::vector<MarkerPart>& parts) {
  Eigen::AlignedBox3d box;
  for (const MarkerPart& part : parts) {
    for (const Vertex& vertex : part.surface->vertices) box.extend(part.X_MarkerPart * vertex.position.cast<double>());
  }
  return box;
}

std::vector<MarkerPart> partsOf(MarkerType type, std::size_t points = 0) {
  world::Marker marker;
  marker.type = type;
  for (std::size_t i = 0; i < points; ++i) marker.points.emplace_back(static_cast<double>(i), 0, 0);
  return MarkerParts().of(marker);
}

TEST(MarkerParts, OfSimpleShapesHaveTheSizeOne) {
  using enum MarkerType;
  for (const MarkerType type : {kBox, kCylinder, kSphere, kCone, kEllipsoid}) {
    const Eigen::AlignedBox3d box = boundsOf(partsOf(type));
    EXPECT_LT((box.min() + Vector3(0.5, 0.5, 0.5)).norm(), 0.01) << static_cast<int>(type);
    EXPECT_LT((box.max() - Vector3(0.5, 0.5, 0.5)).norm(), 0.01) << static_cast<int>(type);
  }
  EXPECT_NEAR(boundsOf(partsOf(kCapsule)).sizes().z(), 2, 1e-6) << "a radius of 0.5 and a length of 1, as in Fortress";
}

TEST(MarkerParts, AreCornersOfListsStripsAndFans) {
  using enum MarkerType;
  const auto cornersOf = [](MarkerType type, std::size_t points) { return partsOf(type, points)[0].surface->corners; };
  EXPECT_EQ(cornersOf(kLineList, 5), (Corners{0, 1, 2, 3})) << "what is left over is not drawn";
  EXPECT_EQ(cornersOf(kLineStrip, 3), (Corners{0, 1, 1, 2}));
  EXPECT_EQ(cornersOf(kTriangleList, 7), (Corners{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(cornersOf(kTriangleStrip, 4), (Corners{0, 1, 2, 1, 2, 3}));
  EXPECT_EQ(cornersOf(kTriangleFan, 4), (Corners{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(cornersOf(kPoints, 2), (Corners{0, 1}));
  EXPECT_EQ(partsOf(kPoints, 2)[0].kind, MarkerPart::Kind::kPoints);
  EXPECT_EQ(partsOf(kLineStrip, 2)[0].kind, MarkerPart::Kind::kLines);
  for (const MarkerType type : {kLineList, kLineStrip, kTriangleList, kTriangleStrip, kTriangleFan, kPoints}) {
    EXPECT_TRUE(cornersOf(type, 0).empty());
  }
}

TEST(MarkerParts, OfAnAxisAreArrowsAlongTheAxes) {
  const std::vector<MarkerPart> arrow = partsOf(MarkerType::kArrow), axis = partsOf(MarkerType::kAxis);
  EXPECT_LT((boundsOf(arrow).max() - Vector3(0.05, 0.05, 0.75)).norm(), 1e-3);
  EXPECT_NEAR(boundsOf(arrow).min().z(), 0, 1e-6);
  ASSERT_EQ(axis.size(), 6U);
  for (int i = 0; i < 3; ++i) {
    const auto first = axis.begin() + 2 * i;
    EXPECT_NEAR(boundsOf({first, first + 2}).max()[i], 0.75, 1e-3);
    EXPECT_EQ(*first->color, Eigen::Vector3f::Unit(i));
  }
}

TEST(MarkerParts, OfATextAreItsDotsCentred) {
  world::Marker marker;
  marker.type = MarkerType::kText;
  marker.text = "HI";
  const std::vector<MarkerPart> parts = MarkerParts().of(marker);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_TRUE(parts[0].facesEye);
  const Eigen::AlignedBox3d box = boundsOf(parts);
  EXPECT_NEAR(box.sizes().z(), 1, 1e-6) << "a letter is 1 high";
  // H has five columns of dots; those of I begin one farther than the space between
  EXPECT_NEAR(box.max().y(), 11.0 / 7 / 2, 1e-6);
  EXPECT_NEAR(box.sizes().x(), 0, 1e-6);
}

TEST(MarkerParts, ShareTheirShapes) {
  MarkerParts parts;
  world::Marker marker;
  marker.type = MarkerType::kSphere;
  EXPECT_EQ(parts.of(marker)[0].surface, parts.of(marker)[0].surface);
}

}  // namespace
}  // namespace pongsim::rendering
