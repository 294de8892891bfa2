#include "physics/hulls/hull_code.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace pongsim::physics {
namespace {

std::vector<Hull> someHulls() { return {{{{0.1, -0.0, 3e-300}, {1, 2, 3}, {4, 5, 6}}, 0.001}, {{{7, 8, 9}}, 0}}; }

TEST(HullCode, GivesBackEveryBit) {
  const std::optional<std::vector<Hull>> hulls = decodeHulls(encodeHulls(someHulls()));
  ASSERT_TRUE(hulls);
  EXPECT_EQ(*hulls, someHulls());
  EXPECT_TRUE(std::signbit((*hulls)[0].corners[0].y()));
}

TEST(HullCode, RefusesWhatIsCutOffOrTooLong) {
  const std::string bytes = encodeHulls(someHulls());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(decodeHulls(std::string_view(bytes).substr(0, length))) << length;
  }
  EXPECT_FALSE(decodeHulls(bytes + '\0'));
}

TEST(HullCode, RefusesNumbersThatCanNotBe) {
  const std::string bytes = encodeHulls(someHulls());
  const auto with = [&](std::size_t place, auto value) {
    static_assert(sizeof value == 8);
    std::string changed = bytes;
    std::memcpy(changed.data() + 8 * place, &value, 8);
    return decodeHulls(changed);
  };
  // count, margin, count of corners, x
  EXPECT_FALSE(with(0, std::uint64_t{0}));
  EXPECT_FALSE(with(0, ~std::uint64_t{0}));
  EXPECT_FALSE(with(1, -0.1));
  EXPECT_FALSE(with(1, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(with(2, std::uint64_t{0}));
  EXPECT_FALSE(with(2, std::uint64_t{1} << 61U));
  EXPECT_FALSE(with(3, std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(with(3, 17.0));
  EXPECT_FALSE(decodeHulls(encodeHulls({})));
}

TEST(HullCode, EndsWithAnyBytes) {
  std::mt19937 random(1);
  const std::string bytes = encodeHulls(someHulls());
  for (int i = 0; i < 20000; ++i) {
    std::string changed = bytes;
    for (int k = 0; k < 1 + i % 4; ++k) changed[random() % changed.size()] = static_cast<char>(random());
    changed.resize(random() % 3 == 0 ? random() % changed.size() : changed.size());
    const auto hulls = decodeHulls(changed);
    if (hulls) {
      EXPECT_EQ(encodeHulls(*hulls), changed);
    }
  }
}

}  // namespace
}  // namespace pongsim::physics
