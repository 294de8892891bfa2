#include "cli/dataset/label_map.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pongsim::cli {
namespace {

using Pixel = std::array<std::uint8_t, 3>;

assets::Picture mapOf(std::size_t width, const std::vector<Pixel>& pixels) {
  assets::Picture map{width, pixels.size() / width, {}};
  for (const Pixel& pixel : pixels) map.pixels.insert(map.pixels.end(), {pixel[0], pixel[1], pixel[2], 255});
  return map;
}

constexpr Pixel kNone{};
using Runs = std::vector<std::uint64_t>;

TEST(LabelMap, OfASemanticCameraHasCrowds) {
  constexpr Pixel kSeven{7, 7, 7}, kNine{9, 9, 9};
  // four columns, two rows
  const auto things = thingsIn(mapOf(4, {kNone, kSeven, kSeven, kNine,  //
                                         kNone, kSeven, kNone, kSeven}));
  ASSERT_EQ(things.size(), 2U);
  EXPECT_EQ(things[0].label, 7);
  EXPECT_TRUE(things[0].isCrowd);
  EXPECT_EQ(things[0].mask->runs, (Runs{2, 3, 2, 1}));
  EXPECT_EQ(things[0].mask->area, 4U);
  EXPECT_EQ(things[0].box.min(), Eigen::Vector2d(1, 0));
  EXPECT_EQ(things[0].box.max(), Eigen::Vector2d(4, 2));
  EXPECT_EQ(things[1].label, 9);
  EXPECT_EQ(things[1].mask->runs, (Runs{6, 1, 1}));
}

TEST(LabelMap, OfAPanopticCameraHasInstances) {
  constexpr Pixel kFirst{1, 0, 7}, kSecond{2, 0, 7}, kMany{44, 1, 7};
  const auto things = thingsIn(mapOf(2, {kFirst, kSecond, kFirst, kMany}));
  ASSERT_EQ(things.size(), 3U);
  for (const LabelledThing& thing : things) {
    EXPECT_EQ(thing.label, 7);
    EXPECT_FALSE(thing.isCrowd);
  }
  // begins with pixels that show it
  EXPECT_EQ(things[0].mask->runs, (Runs{0, 2, 2}));
  EXPECT_EQ(things[1].mask->runs, (Runs{2, 1, 1}));
  EXPECT_EQ(things[2].mask->runs, (Runs{3, 1}));
}

TEST(LabelMap, IsEmptyWhereNothingHasALabel) { EXPECT_TRUE(thingsIn(mapOf(2, {kNone, kNone})).empty()); }

}  // namespace
}  // namespace pongsim::cli
