#include "msgs/state/state_reader.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/serialized_map.pb.h>

#include "msgs/state/component.hh"
#include "msgs/state/state_message.hh"
#include "support/msgs/scene_support.hh"

namespace pongsim::msgs {
namespace {

TEST(StateReader, FindsWhatWasWritten) {
  const description::World world = test::cartWorld();
  const world::Entities entities(world);
  world::State state(entities);
  state.joints[0].position = 0.25;
  ignition::msgs::SerializedStepMap step;
  setState(entities, state, StateContent::kAll, false, step);
  const std::vector<EntityState> read = entitiesOf(step);
  ASSERT_EQ(read.size(), 13U);
  EXPECT_EQ(read[0].kind, EntityState::Kind::kWorld);
  EXPECT_EQ(read[1].kind, EntityState::Kind::kModel);
  EXPECT_TRUE(read[1].isStatic);
  const EntityState& base = read[4];
  EXPECT_EQ(base.name, "base");
  EXPECT_EQ(base.kind, EntityState::Kind::kLink);
  EXPECT_EQ(base.parent, 4U);
  EXPECT_EQ(base.pose->position.z(), 2);
  EXPECT_EQ(base.inertial, world.models[1].links[0].inertial);
  const EntityState& gyro = read[8];
  EXPECT_EQ(gyro.kind, EntityState::Kind::kSensor);
  ASSERT_TRUE(gyro.sensor);
  EXPECT_EQ(gyro.sensor->type, "imu");
  const EntityState& hinge = read[11];
  EXPECT_EQ(hinge.kind, EntityState::Kind::kJoint);
  EXPECT_EQ(hinge.jointType, "revolute");
  EXPECT_EQ(hinge.parentLink, "base");
  EXPECT_EQ(hinge.childLink, "arm::tip");
  EXPECT_EQ(hinge.axes, std::vector<Vector3>{Vector3::UnitY()});
  EXPECT_EQ(hinge.positions, std::vector<double>{0.25});
}

TEST(StateReader, LeavesOutWhatItCanNotRead) {
  ignition::msgs::SerializedStepMap step;
  auto& components = *(*step.mutable_state()->mutable_entities())[7].mutable_components();
  for (const char* name : {"Joint", "Pose", "ParentEntity", "JointType", "JointAxis", "Inertial", "JointPosition"}) {
    components[static_cast<std::int64_t>(componentType(name))].set_component("\xff no such thing");
  }
  const std::vector<EntityState> read = entitiesOf(step);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].id, 7U);
  EXPECT_FALSE(read[0].pose);
  EXPECT_FALSE(read[0].inertial);
  EXPECT_EQ(read[0].jointType, "");
  EXPECT_TRUE(read[0].axes.empty());
}

}  // namespace
}  // namespace pongsim::msgs
