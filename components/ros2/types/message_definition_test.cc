#include "ros2/types/message_definition.hh"

#include <gtest/gtest.h>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/rcl_interfaces.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {
namespace {

const std::string kLine(80, '=');

TEST(MessageDefinition, HasTheTypeFirstAndThenWhatIsInIt) {
  EXPECT_EQ(messageDefinition<geometry_msgs::TwistStamped>(),
            "std_msgs/Header header\ngeometry_msgs/Twist twist\n" + kLine +
                "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + kLine +
                "\nMSG: geometry_msgs/Twist\ngeometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n" + kLine +
                "\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n" + kLine +
                "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n");
}

struct Lists {
  static constexpr const char* kName = "test_msgs/msg/Lists";
  std::array<double, 9> k{};
  std::vector<std::uint8_t> data;
  std::vector<std::string> names;
  BoundedList<BoundedString<5>, 4> words;
  std::vector<bool> flags;
  std::vector<std::byte> bytes;
  std::int8_t small = 0;
  static void visit(auto& self, auto&& field) {
    field("k", self.k);
    field("data", self.data);
    field("names", self.names);
    field("words", self.words);
    field("flags", self.flags);
    field("bytes", self.bytes);
    field("small", self.small);
  }
};

TEST(MessageDefinition, WritesListsArraysAndBounds) {
  EXPECT_EQ(
      messageDefinition<Lists>(),
      "float64[9] k\nuint8[] data\nstring[] names\nstring<=5[<=4] words\nbool[] flags\nbyte[] bytes\nint8 small\n");
}

TEST(MessageDefinition, IsTheSameWhereTheBytesAreElsewhere) {
  EXPECT_EQ(messageDefinition<sensor_msgs::BasicImage<BulkBytes>>(), messageDefinition<sensor_msgs::Image>());
}

TEST(MessageDefinition, OfATypeWithoutFieldsIsEmpty) { EXPECT_EQ(messageDefinition<std_msgs::Empty>(), ""); }

}  // namespace
}  // namespace pongsim::ros2
