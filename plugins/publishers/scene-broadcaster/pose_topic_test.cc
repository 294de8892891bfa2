#include "pose_topic.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/running_world.hh"

namespace pongsim::pose_topic_test {
namespace {

const std::string kContent = R"(<gravity>0 0 0</gravity>
  <model name="floor"><static>true</static><link name="slab"><visual name="look"><pose>0 0 4 0 0 0</pose>
    <geometry><sphere><radius>1</radius></sphere></geometry></visual></link></model>
  <model name="outer"><pose>1 0 0 0 0 0</pose><link name="base"><light name="lamp" type="point"><pose>0 5 0 0 0 0</pose>
    </light></link>
    <model name="inner"><pose>0 2 0 0 0 0</pose><link name="tip"><pose>0 0 3 0 0 0</pose></link></model></model>
  <light name="sun" type="directional"><pose>0 0 10 0 0 0</pose></light>)";

/// @return "name x y z" of each pose that the topic tells.
std::vector<std::string> told(bool isMoving) {
  test::RunningWorld running(kContent);
  std::vector<ignition::msgs::Pose_V> messages;
  running.listen("/poses", messages);
  Node node = running.simulation().transport().node();
  PoseTopic topic;
  topic.open(node, "/poses");
  topic.tellOf(running.simulation().world(), isMoving);
  topic.publish(Time(1'500'000'000));
  running.simulation().transport().dispatch();
  std::vector<std::string> poses;
  if (messages.size() != 1) return poses;
  EXPECT_EQ(messages[0].header().stamp().nsec(), 500'000'000);
  for (const ignition::msgs::Pose& pose : messages[0].pose()) {
    EXPECT_NE(pose.id(), 0U);
    const auto number = [](double value) { return " " + std::to_string(static_cast<int>(value)); };
    poses.push_back(pose.name() + number(pose.position().x()) + number(pose.position().y()) +
                    number(pose.position().z()));
  }
  return poses;
}

TEST(PoseTopic, TellsAllInTheFrameOfWhatHoldsIt) {
  EXPECT_EQ(told(false),
            (std::vector<std::string>{"floor 0 0 0", "outer 1 0 0", "inner 0 2 0", "slab 0 0 0", "base 0 0 0",
                                      "tip 0 0 3", "look 0 0 4", "lamp 0 5 0", "sun 0 0 10"}));
}

TEST(PoseTopic, TellsOfWhatIsNotStatic) {
  EXPECT_EQ(told(true), (std::vector<std::string>{"outer 1 0 0", "inner 0 2 0", "base 0 0 0", "tip 0 0 3"}));
}

}  // namespace
}  // namespace pongsim::pose_topic_test
