#include "ros2/controllers/parameter_files.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "ros2/controllers/controller_parameters.hh"
#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

using Words = std::vector<std::string>;

class ParameterFilesTest : public testing::Test {
 protected:
  std::string read(const std::string& text) { return files_.read(folder_.write("p.yaml", text)); }

  test::TempFolder folder_;
  ParameterFiles files_;
};

TEST_F(ParameterFilesTest, ReadsTypesAndNestedNames) {
  ASSERT_EQ(read("arm:\n  ros__parameters:\n    joints: [a, b]\n    rate: 50\n    gain: 0.5\n    open: true\n"
                 "    text: \"7\"\n    mixed: [1, 2.5]\n    linear:\n      x:\n        max_velocity: 1.5\n"
                 "    linear.x.min_velocity: .nan\n"),
            "");
  ControllerParameters arm(files_.valuesOf("/arm"));
  EXPECT_EQ(arm.texts("joints"), (Words{"a", "b"}));
  EXPECT_EQ(arm.whole("rate", 1), 50);
  EXPECT_EQ(arm.number("rate", 1), 50);
  EXPECT_EQ(arm.number("gain", 1), 0.5);
  EXPECT_TRUE(arm.flag("open", false));
  EXPECT_EQ(arm.text("text", ""), "7");
  EXPECT_EQ(arm.numbers("mixed", {}), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(arm.number("linear.x.max_velocity", 0), 1.5);
  EXPECT_EQ(arm.unknown(), Words{"linear.x.min_velocity"});
  EXPECT_TRUE(std::isnan(arm.number("linear.x.min_velocity", 0)));
  EXPECT_EQ(arm.errors(), Words{});
  EXPECT_EQ(arm.number("absent", 4), 4);
  EXPECT_EQ(arm.whole("gain", 3), 3);
  EXPECT_EQ(arm.numberAboveZero("zero", 0), 0);
  EXPECT_EQ(arm.errors(), (Words{"'gain' must be a whole number", "'zero' must be above zero"}));
  EXPECT_EQ(arm.asked().at("absent").double_value, 4);
}

TEST_F(ParameterFilesTest, FindsNodesByNamespacesAndWildcards) {
  ASSERT_EQ(read("/**:\n  ros__parameters:\n    a: 1\n    b: 1\n"
                 "robot:\n  arm:\n    ros__parameters:\n      b: 2\n"
                 "/**/hand:\n  ros__parameters:\n    c: 3\n"
                 "/*/leg:\n  ros__parameters:\n    d: 4\n"),
            "");
  const auto value = [&](const std::string& node, const std::string& name) {
    return ControllerParameters(files_.valuesOf(node)).whole(name, 0);
  };
  EXPECT_EQ(value("/robot/arm", "a"), 1);
  EXPECT_EQ(value("/robot/arm", "b"), 2);
  EXPECT_EQ(value("/arm", "b"), 1);
  EXPECT_EQ(value("/hand", "c"), 3);
  EXPECT_EQ(value("/robot/hand", "c"), 3);
  EXPECT_EQ(value("/robot/leg", "d"), 4);
  EXPECT_EQ(value("/leg", "d"), 0);
  // later files precede
  ASSERT_EQ(read("robot:\n  arm:\n    ros__parameters:\n      b: 9\n"), "");
  EXPECT_EQ(value("/robot/arm", "b"), 9);
}

TEST_F(ParameterFilesTest, SaysWhatIsWrong) {
  EXPECT_EQ(files_.read(folder_.path() / "none.yaml"), "there is no such file");
  EXPECT_EQ(files_.read(folder_.path()), "it is not a regular file");
  EXPECT_TRUE(read("a: [1\nb").starts_with("line "));
}

}  // namespace
}  // namespace pongsim::ros2
