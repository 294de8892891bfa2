#include "ign/names.hh"

#include <gtest/gtest.h>

#include <cstdlib>

namespace pongsim::ign {
namespace {

TEST(Names, HaveThePartitionInFront) {
  setenv("IGN_PARTITION", "here", 1);
  EXPECT_EQ(wireName("/clock"), "@/here@/clock");
  EXPECT_EQ(wireName("/a b"), std::nullopt);
  EXPECT_EQ(wireName(""), std::nullopt);
  unsetenv("IGN_PARTITION");
}

}  // namespace
}  // namespace pongsim::ign
