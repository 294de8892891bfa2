#include "ros2/doctor/checks.hh"

#include "support/ros2/healthy_robot.hh"

namespace pongsim::ros2 {
namespace {

using test::frameIn;

TEST(DoctorChecks, FindNothingWrongWithAHealthyRobot) {
  const Findings findings = checkAll(test::healthyRobot(), {});
  EXPECT_GT(findings.size(), 8U);
  for (const Finding& each : findings) {
    EXPECT_EQ(each.verdict, Finding::Verdict::kGood) << each.text;
    EXPECT_TRUE(each.remedy.empty());
    EXPECT_FALSE(each.users.empty()) << each.text;
  }
}

TEST(DoctorChecks, KnowFramesByTheirChildrenToo) {
  const std::map<std::string, FrameSeen> frames = {
      {"b", frameIn("a")}, {"c", frameIn("b")}, {"x", frameIn("y")}, {"y", frameIn("x")}};
  EXPECT_EQ(rootOf(frames, "c"), "a");
  EXPECT_EQ(rootOf(frames, "other"), "other");
  EXPECT_EQ(rootOf(frames, "x"), "");
  EXPECT_TRUE(isKnown(frames, "a"));
  EXPECT_TRUE(isKnown(frames, "c"));
  EXPECT_FALSE(isKnown(frames, "d"));
}

TEST(DoctorChecks, WriteNamesAndNumbersForPeople) {
  EXPECT_EQ(quoted({"a", "b"}), "'a', 'b'");
  EXPECT_EQ(quoted({"1", "2", "3", "4", "5", "6", "7", "8", "9", "a"}),
            "'1', '2', '3', '4', '5', '6', '7', '8' and 2 more");
  EXPECT_EQ(rounded(4.99999), "5");
  EXPECT_EQ(rounded(0.123456), "0.123");
  EXPECT_EQ(rounded(1700000000.4), "1700000000");
}

}  // namespace
}  // namespace pongsim::ros2
