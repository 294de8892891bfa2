#include "ros2/robot/odometry.hh"

#include "support/ros2/robot_world.hh"

namespace pongsim::ros2 {
namespace {

using test::inWorld;
using test::worldOf;
using Words = std::vector<std::string>;

TEST(Odometry, IsWhereAPluginSaysAndWhereDrivesSpeak) {
  const auto simulation = worldOf(
      inWorld("<model name='a'><link name='l'/><plugin filename='libignition-gazebo-diff-drive-system.so' name='n'/>"
              "<plugin filename='x' name='n'><tf_topic>my tf</tf_topic></plugin></model>"
              "<model name='b'><link name='l'/><plugin filename='ignition-gazebo-odometry-publisher-system' name='n'/>"
              "</model>"));
  EXPECT_EQ(odometryTopics(simulation->world().model("a").value()), (Words{"/my_tf", "/model/a/tf"}));
  EXPECT_EQ(odometryTopics(simulation->world().model("b").value()), (Words{"/model/b/tf", "/model/b/pose"}));
}

TEST(Odometry, IsTheFirstTopicThatIsPublished) {
  const auto simulation =
      worldOf(inWorld("<model name='a'><link name='l'/><plugin filename='x' name='n'><tf_topic>tf</tf_topic></plugin>"
                      "</model>"));
  const Model model = simulation->world().model("a").value();
  EXPECT_EQ(odometryTopic(model, {}), "");
  const OwnTopic heard{"/tf", "ignition.msgs.Pose_V", 0, 1}, other{"/tf", "ignition.msgs.Pose", 1, 0},
      drive{"/model/a/tf", "ignition.msgs.Pose_V", 1, 0}, own{"/tf", "ignition.msgs.Pose_V", 1, 0};
  EXPECT_EQ(odometryTopic(model, {heard, other}), "");
  EXPECT_EQ(odometryTopic(model, {drive, heard}), "/model/a/tf");
  EXPECT_EQ(odometryTopic(model, {drive, own}), "/tf");
}

}  // namespace
}  // namespace pongsim::ros2
