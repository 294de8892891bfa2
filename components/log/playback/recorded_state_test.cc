#include "log/playback/recorded_state.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/serialized.pb.h>

#include <string>

#include "pongsim/components.hh"

namespace pongsim::log {
namespace {

Pose poseReadFrom(const std::string& text) {
  ignition::msgs::SerializedState message;
  ignition::msgs::SerializedEntity& entity = *message.add_entities();
  entity.set_id(7);
  ignition::msgs::SerializedComponent& component = *entity.add_components();
  component.set_type(componentType("Pose"));
  component.set_component(text);
  RecordedState state;
  EXPECT_TRUE(state.apply("ignition.msgs.SerializedState", message.SerializeAsString()));
  return state.poseOf(7);
}

TEST(RecordedState, HasNoPoseWhereNoneIsPossible) {
  EXPECT_EQ(poseReadFrom("1 2 -1e9 0 0 0").position, Vector3(1, 2, -1e9));
  for (const char* text :
       {"nan 0 0 0 0 0", "0 inf 0 0 0 0", "0 0 1e10 0 0 0", "1 2 3 0 nan 0", "1 2 3 inf 0 0", "1 2"}) {
    EXPECT_EQ(poseReadFrom(text), Pose()) << text;
  }
}

}  // namespace
}  // namespace pongsim::log
