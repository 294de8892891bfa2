#include "msgs/state/state_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <chrono>

#include "msgs/state/component.hh"
#include "support/msgs/scene_support.hh"

namespace pongsim::msgs {
namespace {

class StateMessageTest : public testing::Test {
 protected:
  void write(StateContent content) { setState(entities_, state_, content, true, step_); }

  /// @return The component's bytes, or "none".
  std::string component(std::uint64_t id, const char* name) {
    const auto& components = (*step_.mutable_state()->mutable_entities())[id].components();
    const auto found = components.find(static_cast<std::int64_t>(componentType(name)));
    return found == components.end() ? "none" : found->second.component();
  }

  const description::World world_ = test::cartWorld();
  const world::Entities entities_{world_};
  world::State state_{entities_};
  ignition::msgs::SerializedStepMap step_;
};

TEST_F(StateMessageTest, TellsOfTheTime) {
  state_.time = std::chrono::milliseconds(2500);
  state_.iterations = 17;
  write(StateContent::kAll);
  EXPECT_EQ(step_.stats().sim_time().sec(), 2);
  EXPECT_EQ(step_.stats().sim_time().nsec(), 500'000'000);
  EXPECT_EQ(step_.stats().iterations(), 17U);
  EXPECT_TRUE(step_.stats().paused());
  EXPECT_EQ(step_.state().header().stamp().sec(), 2);
}

TEST_F(StateMessageTest, WritesComponentsAsFortressDoes) {
  write(StateContent::kAll);
  EXPECT_EQ(component(1, "World"), "");
  EXPECT_EQ(component(1, "Name"), "w");
  EXPECT_EQ(component(1, "Gravity"), "0 0 -9.8");
  EXPECT_EQ(component(2, "Static"), "1");
  EXPECT_EQ(component(4, "Name"), "cart");
  EXPECT_EQ(component(4, "ParentEntity"), "1");
  EXPECT_EQ(component(4, "Pose"), "1 0 0 0 0 0");
  EXPECT_EQ(component(5, "CanonicalLink"), "");
  EXPECT_EQ(component(6, "CastShadows"), "1");
  EXPECT_EQ(component(6, "Transparency"), "0");
  EXPECT_EQ(component(6, "VisibilityFlags"), "4294967295");
  EXPECT_EQ(component(6, "LaserRetro"), "none");
  EXPECT_NE(component(1, "Scene"), "none");
  EXPECT_EQ(component(12, "JointType"), "6");
  EXPECT_EQ(component(12, "ParentLinkName"), "base");
  EXPECT_EQ(component(12, "JointAxis2"), "none");
  // all of them, collisions too
  EXPECT_EQ(step_.state().entities_size(), 13);
}

TEST_F(StateMessageTest, TellsOfBatteries) {
  state_.batteries.push_back({BatteryId{50}, ModelId{4}, "cell", 0.25, {}});
  state_.batteries.push_back({BatteryId{51}, ModelId{99}, "of a model that is set aside", 1, {}});
  write(StateContent::kAll);
  EXPECT_EQ(component(50, "Name"), "cell");
  EXPECT_EQ(component(50, "ParentEntity"), "4");
  EXPECT_EQ(component(50, "BatterySoC"), "0.25");
  EXPECT_EQ(component(51, "Name"), "none");
  write(StateContent::kMoving);
  EXPECT_EQ(component(50, "BatterySoC"), "0.25");
  EXPECT_EQ(component(50, "Name"), "none");
}

TEST_F(StateMessageTest, TellsOfWhatMovesOnly) {
  write(StateContent::kMoving);
  EXPECT_EQ(step_.state().entities_size(), 5) << "cart, base, arm, tip, hinge";
  EXPECT_EQ(component(4, "Name"), "none");
  EXPECT_EQ(component(10, "Pose"), "0 0 3 0 0 0");
  EXPECT_NE(component(12, "JointPosition"), "none");
}

}  // namespace
}  // namespace pongsim::msgs
