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

TEST(Names, OfTypesAreThoseOfTheGeneration) {
  EXPECT_EQ(wireType("ignition.msgs.Twist", Generation::kIgn), "ignition.msgs.Twist");
  EXPECT_EQ(wireType("ignition.msgs.Twist", Generation::kGz), "gz.msgs.Twist");
  EXPECT_EQ(wireType("my.ignition.msgs.Twist", Generation::kGz), "my.ignition.msgs.Twist");
  for (const char* type : {"gz.msgs.Twist", "ignition.msgs.Twist"}) EXPECT_EQ(ownType(type), "ignition.msgs.Twist");
  EXPECT_EQ(ownType("google.protobuf.Message"), "google.protobuf.Message");
}

}  // namespace
}  // namespace pongsim::ign
