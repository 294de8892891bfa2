// The expected hashes were recorded once. They must be the same on every machine.

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "base/hash.hh"
#include "pongsim/math.hh"
#include "support/base/last_places.hh"

namespace pongsim::math {
namespace {

/// @return A hash of all bits of a function's results.
template <class Function>
std::uint64_t bitsOf(Function function, const std::vector<test::Range>& ranges) {
  base::Hash hash;
  Random random(1, "numbers");
  for (const test::Range& range : ranges) {
    for (int i = 0; i < 20'000; ++i) hash.add(function(test::drawn(random, range)));
  }
  return hash.value();
}

// no range has `isOfPowers`, whose numbers come from the C library's exp2, which differs between machines
TEST(SameBits, AreThoseThatWereWrittenDown) {
  const std::vector<test::Range> angles = {{-0.8, 0.8}, {-10, 10}, {-1e6, 1e6}, {-1e18, 1e18}, {-1e300, 1e300}};
  EXPECT_EQ(bitsOf(sin, angles), 0x48e5f217f875e984ULL);
  EXPECT_EQ(bitsOf(cos, angles), 0xdda471d5c0d4eb7bULL);
  EXPECT_EQ(bitsOf(tan, angles), 0xf976682c79f6a872ULL);
  EXPECT_EQ(bitsOf(asin, {{-1, 1}, {-1e-3, 1e-3}}), 0xbc0afff8d8addf32ULL);
  EXPECT_EQ(bitsOf(acos, {{-1, 1}, {-1e-3, 1e-3}}), 0x5008065c9783967eULL);
  EXPECT_EQ(bitsOf(atan, {{-5, 5}, {-1e6, 1e6}}), 0x42c42cff55f966f1ULL);
  EXPECT_EQ(bitsOf([](double x) { return atan2(x, 0.7) + atan2(-0.7, x); }, {{-5, 5}, {-1e6, 1e6}}),
            0xd8f00d433551a8a8ULL);
  EXPECT_EQ(bitsOf(exp, {{-5, 5}, {-745, 709}}), 0x107150ddbbdbcd5fULL);
  EXPECT_EQ(bitsOf(expm1, {{-1, 1}, {-40, 709}}), 0x0359d32464772b7cULL);
  EXPECT_EQ(bitsOf(log, {{0, 2}, {0, 1e300}}), 0xfdd12b7eb7182de1ULL);
  EXPECT_EQ(bitsOf(log1p, {{-0.5, 1e-3}, {-1e-9, 1e6}}), 0x7e6646b68d1cfa8fULL);
  EXPECT_EQ(bitsOf(erfc, {{-6, 26}}), 0xc9617bcc15c65564ULL);
  EXPECT_EQ(bitsOf([](double x) { return hypot(x, 0.7); }, {{-5, 5}, {-1e6, 1e6}}), 0x6db6cc4ab5ef45baULL);
}

}  // namespace
}  // namespace pongsim::math
