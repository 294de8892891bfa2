#include "msgs/fields/number_check.hh"

#include <gtest/gtest.h>

#include <string>

namespace pongsim {
namespace {

constexpr double kLargest = 1000;

/// @return The error for a message with that text.
std::optional<std::string> faultOf(const std::string& type, const std::string& text) {
  const MessagePointer message = newMessage(type);
  EXPECT_FALSE(parseMessage(text, *message)) << text;
  return msgs::unusableNumber(*message, kLargest);
}

TEST(NumberCheck, TakesWhatIsFiniteAndWithinTheBound) {
  EXPECT_EQ(faultOf("Twist", "linear {x: 1000 y: -1000 z: 1e-308} angular {z: 3}"), std::nullopt);
  EXPECT_EQ(faultOf("Double", ""), std::nullopt);
  EXPECT_EQ(faultOf("Float_V", "data: [1, 2, 3]"), std::nullopt);
  EXPECT_EQ(faultOf("StringMsg", "data: '1e308'"), std::nullopt);
}

TEST(NumberCheck, NamesTheNumberAndItsPlace) {
  EXPECT_EQ(faultOf("Double", "data: 1e308"), "data is 1e+308");
  EXPECT_EQ(faultOf("Double", "data: -1000.5"), "data is -1000.5");
  EXPECT_EQ(faultOf("Double", "data: nan"), "data is nan");
  EXPECT_EQ(faultOf("Float", "data: -inf"), "data is -inf");
  EXPECT_EQ(faultOf("Twist", "linear {x: 1} angular {z: inf}"), "angular.z is inf");
  EXPECT_EQ(faultOf("Float_V", "data: [1, 2, 3e30]"), "data[2] is 3e+30");
  EXPECT_EQ(faultOf("JointTrajectory", "points {positions: 1} points {positions: 1 positions: 1e40}"),
            "points[1].positions[1] is 1e+40");
}

TEST(NumberCheck, FindsTimesThatNanosecondsCantCount) {
  EXPECT_EQ(faultOf("Time", "sec: 4000000000"), std::nullopt);
  EXPECT_EQ(faultOf("Time", "sec: -9000000000"), "sec is -9000000000 (more than 4000000000)");
  EXPECT_EQ(faultOf("JointTrajectory", "points {time_from_start {sec: 9223372036854775807}}"),
            "points[0].time_from_start.sec is 9223372036854775807 (more than 4000000000)");
  EXPECT_EQ(faultOf("Int64", "data: 9223372036854775807"), std::nullopt) << "a whole number is no measure";
}

}  // namespace
}  // namespace pongsim
