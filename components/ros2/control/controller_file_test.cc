#include "ros2/control/controller_file.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

class ControllerFileTest : public testing::Test {
 protected:
  ControllerFile read(const std::string& text) {
    folder_.write("c.yaml", text);
    return readControllerFile(folder_.path() / "c.yaml");
  }
  const pongsim::test::TempFolder folder_;
};

TEST_F(ControllerFileTest, TellsTheManagersRateAndTheGain) {
  const ControllerFile file = read(
      "controller_manager:\n  ros__parameters:\n    update_rate: 250  # Hz\n    broadcaster:\n      type: b\n"
      "arm_controller:\n  ros__parameters:\n    update_rate: 5\n"
      "gz_ros_control:\n  ros__parameters:\n    position_proportional_gain: 0.5\n    hold_joints: false\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.updateRate, 250);
  EXPECT_EQ(file.positionGain, 0.5);
  EXPECT_EQ(file.holdsJoints, false);
}

TEST_F(ControllerFileTest, LooksIntoNamespaces) {
  EXPECT_EQ(read("robot:\n  controller_manager:\n    ros__parameters:\n      update_rate: 50\n").updateRate, 50);
  EXPECT_EQ(read("a: 1\n").updateRate, std::nullopt);
}

TEST_F(ControllerFileTest, SaysWhatIsWrong) {
  EXPECT_EQ(readControllerFile(folder_.path() / "other.yaml").error, "there is no such file");
  EXPECT_EQ(readControllerFile(folder_.path()).error, "it is not a regular file");
  EXPECT_TRUE(read("controller_manager:\n  ros__parameters:\n    update_rate: fast\n")
                  .error.starts_with("line 3, column 18: "));
  EXPECT_TRUE(read("a: [1\n").error.starts_with("line 2, column 1: "));
  EXPECT_EQ(read("controller_manager:\n  ros__parameters:\n    update_rate: -1\n").error,
            "update_rate and position_proportional_gain must be above zero");
}

}  // namespace
}  // namespace pongsim::ros2
