#include "sensing/shape.hh"

#include <gtest/gtest.h>

namespace pongsim::sensing {
namespace {

struct PassageCase {
  const char* what;
  Shape shape;
  Line line;
  /// Nothing: it passes by.
  std::optional<Passage> expected;
};

void expectPassage(const PassageCase& each) {
  SCOPED_TRACE(each.what);
  const std::optional<Passage> found = passage(each.shape, each.line);
  ASSERT_EQ(found.has_value(), each.expected.has_value());
  if (!found) return;
  EXPECT_DOUBLE_EQ(found->enter, each.expected->enter);
  EXPECT_DOUBLE_EQ(found->leave, each.expected->leave);
}

TEST(Shape, TellsWhereALineEntersAndLeaves) {
  const description::Box box{{2, 4, 6}};
  const description::Cylinder cylinder{1, 4};
  const description::Capsule capsule{1, 4};
  const description::Cone cone{1, 4};
  const Line along{{-5, 0, 0}, {1, 0, 0}}, down{{0, 0, 10}, {0, 0, -1}};
  const PassageCase cases[] = {
      {"box", box, along, Passage{4, 6}},
      {"box, a direction that is twice as long", box, {{-5, 0, 0}, {2, 0, 0}}, Passage{2, 3}},
      {"box, from within", box, {{0, 0, 0}, {0, 0, 1}}, Passage{-3, 3}},
      {"box, beside it", box, {{-5, 2.1, 0}, {1, 0, 0}}, std::nullopt},
      {"box, across its corner", box, {{-2, 2, 0}, {1, 1, 0}}, std::nullopt},
      {"sphere", description::Sphere{2}, along, Passage{3, 7}},
      {"sphere, beside it", description::Sphere{2}, {{-5, 2.1, 0}, {1, 0, 0}}, std::nullopt},
      {"cylinder, side", cylinder, along, Passage{4, 6}},
      {"cylinder, along its axis", cylinder, down, Passage{8, 12}},
      {"cylinder, along its axis beside it", cylinder, {{1.1, 0, 10}, {0, 0, -1}}, std::nullopt},
      {"cylinder, above it", cylinder, {{-5, 0, 2.1}, {1, 0, 0}}, std::nullopt},
      {"capsule, side", capsule, along, Passage{4, 6}},
      {"capsule, ends", capsule, down, Passage{7, 13}},
      {"ellipsoid", description::Ellipsoid{{1, 2, 3}}, down, Passage{7, 13}},
      {"cone, side", cone, along, Passage{4.5, 5.5}},
      {"cone, along its axis", cone, down, Passage{8, 12}},
      {"cone, upwards along its axis", cone, {{0, 0, -10}, {0, 0, 1}}, Passage{8, 12}},
      {"cone, along its axis beside the tip", cone, {{0.5, 0, 10}, {0, 0, -1}}, Passage{10, 12}},
      {"cone, above its tip", cone, {{-5, 0, 2.1}, {1, 0, 0}}, std::nullopt},
      {"cone, where its mirror image would be", cone, {{-5, 0, 3}, {1, 0, 0}}, std::nullopt},
      {"cone, below it", cone, {{-5, 0, -2.1}, {1, 0, 0}}, std::nullopt},
      {"cone, parallel to its side", cone, {{-0.5, 0, -2}, {0.25, 0, 1}}, Passage{0, 3}},
      {"cone, parallel to its side, downwards", cone, {{-0.5, 0, -2}, {-0.25, 0, -1}}, Passage{-3, 0}},
      {"sheet, from its outside", Sheet{{1, 1}}, down, Passage{10, kNowhere}},
      {"sheet, from its inside", Sheet{{1, 1}}, {{0, 0, -3}, {0, 0, 1}}, Passage{-kNowhere, 3}},
      {"sheet, beside it", Sheet{{1, 1}}, {{1.1, 0, 10}, {0, 0, -1}}, std::nullopt},
      {"sheet, along it", Sheet{{1, 1}}, along, std::nullopt},
  };
  for (const PassageCase& each : cases) expectPassage(each);
}

TEST(Shape, LosesNoDigitsFarAway) {
  // a ball of 1 mm, 10 km away
  const auto found = passage(description::Sphere{1e-3}, {{-1e4, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->enter, 1e4 - 1e-3, 1e-10);
}

TEST(FirstSeen, IsOnTheOutsideUnlessTheInsideIsSeen) {
  EXPECT_EQ(firstSeen({2, 5}, 0, false), 2);
  EXPECT_EQ(firstSeen({2, 5}, 3, false), kNowhere);
  EXPECT_EQ(firstSeen({2, 5}, 3, true), 5);
  EXPECT_EQ(firstSeen({-5, -2}, 0, true), kNowhere);
}

}  // namespace
}  // namespace pongsim::sensing
