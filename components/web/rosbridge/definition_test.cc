#include "web/rosbridge/definition.hh"

#include <gtest/gtest.h>

namespace pongsim::web::rosbridge {
namespace {

TEST(RosDefinition, HasTheTypesOfAllFields) {
  const auto read = readDefinition(
      "std_msgs/Header header\nfloat64[36] covariance\nstring<=5[<=4] words\nbyte[] data\n"
      "================\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"
      "================\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->types.size(), 3U);
  const std::vector<RosField>& fields = read->types[0];
  ASSERT_EQ(fields.size(), 4U);
  EXPECT_EQ(fields[0].kind, Kind::kMessage);
  EXPECT_EQ(read->types[fields[0].type][1].name, "frame_id");
  EXPECT_EQ(fields[1].count, Count::kArray);
  EXPECT_EQ(fields[1].size, 36U);
  EXPECT_EQ(fields[2].kind, Kind::kString);
  EXPECT_EQ(fields[2].count, Count::kList);
  EXPECT_EQ(fields[3].kind, Kind::kUint8);
  EXPECT_EQ(readDefinition("")->types.size(), 1U) << "std_msgs/Empty";
}

TEST(RosDefinition, IsRefusedWhereItIsNone) {
  EXPECT_FALSE(readDefinition("float64"));
  EXPECT_FALSE(readDefinition("other/Type x\n"));
  EXPECT_FALSE(readDefinition("float64[x] y\n"));
  EXPECT_FALSE(readDefinition("a/B b\n==\nMSG: a/B\na/B b\n")) << "it contains itself";
}

}  // namespace
}  // namespace pongsim::web::rosbridge
