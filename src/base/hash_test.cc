#include "base/hash.hh"

#include <gtest/gtest.h>

namespace pongsim::base {
namespace {

TEST(Hash, GivesThePublishedNumbers) {
  EXPECT_EQ(Hash().value(), 0xcbf29ce484222325ULL);
  Hash hash;
  hash.add("foobar");
  EXPECT_EQ(hash.value(), 0x85944171f73967e8ULL);
}

TEST(Hash, TellsZeroFromMinusZero) {
  Hash zero, minusZero;
  zero.add(0.0);
  minusZero.add(-0.0);
  EXPECT_NE(zero.value(), minusZero.value());
}

}  // namespace
}  // namespace pongsim::base
