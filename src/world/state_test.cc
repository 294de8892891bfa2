#include "world/state.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::world {
namespace {

description::World twoLinks() {
  description::Model inner;
  inner.name = "inner";
  inner.canonicalLink = "tip";
  inner.X_ParentModel.position.x() = 2;
  inner.links.resize(1);
  inner.links[0].name = "tip";
  inner.links[0].X_ModelLink.position.z() = 1;

  description::Model outer;
  outer.name = "outer";
  outer.canonicalLink = "inner::tip";
  outer.X_ParentModel = {{10, 0, 0}, fromRollPitchYaw(0, 0, M_PI / 2)};
  outer.models = {inner};
  outer.joints.resize(1);
  outer.joints[0].parent = "world";
  outer.joints[0].child = "inner::tip";

  description::World world;
  world.models = {outer};
  return world;
}

TEST(State, StartsWhereTheNestedPosesLead) {
  const description::World world = twoLinks();
  const Entities entities(world);
  const State state(entities);
  ASSERT_EQ(state.links.size(), 1U);
  EXPECT_TRUE(state.links[0].X_WorldLink.position.isApprox(Vector3(10, 2, 1)));
  EXPECT_EQ(state.joints.size(), 1U);
  EXPECT_EQ(state.iterations, 0U);
}

TEST(ModelPose, MovesWithTheCanonicalLink) {
  const description::World world = twoLinks();
  const Entities entities(world);
  State state(entities);
  const Slot outer = entities.findModel("outer");
  EXPECT_TRUE(modelPose(entities, state, outer).position.isApprox(Vector3(10, 0, 0)));
  state.links[0].X_WorldLink.position += Vector3(0, 0, 3);
  EXPECT_TRUE(modelPose(entities, state, outer).position.isApprox(Vector3(10, 0, 3)));
}

TEST(PoseInParent, IsThatOfNow) {
  const description::World world = twoLinks();
  const Entities entities(world);
  State state(entities);
  const Slot inner = entities.findModel("outer::inner");
  EXPECT_TRUE(poseInParent(entities, state, inner).position.isApprox(Vector3(2, 0, 0)));
  EXPECT_TRUE(poseInParent(entities, state, entities.findModel("outer")).position.isApprox(Vector3(10, 0, 0)));
}

TEST(PoseInModel, OfTheCanonicalLinkNeverChanges) {
  description::World world = twoLinks();
  world.models[0].models[0].links.push_back(world.models[0].models[0].links[0]);
  world.models[0].models[0].links[1].name = "other";
  const Entities entities(world);
  State state(entities);
  for (LinkState& link : state.links) link.X_WorldLink.position += Vector3(0.1, 0.2, 0.3);
  EXPECT_EQ(poseInModel(entities, state, 0).position, Vector3(0, 0, 1));
  state.links[1].X_WorldLink.position.z() += 4;
  EXPECT_TRUE(poseInModel(entities, state, 1).position.isApprox(Vector3(0, 0, 5)));
}

TEST(StateHash, ChangesWithEveryValue) {
  const description::World world = twoLinks();
  const Entities entities(world);
  const State start(entities);
  EXPECT_EQ(stateHash(start), stateHash(State(entities)));

  const auto changed = [&](auto change) {
    State state = start;
    change(state);
    return stateHash(state) != stateHash(start);
  };
  EXPECT_TRUE(changed([](State& s) { s.time += Time(1); }));
  EXPECT_TRUE(changed([](State& s) { s.iterations = 1; }));
  EXPECT_TRUE(changed([](State& s) { s.links[0].X_WorldLink.position.z() = std::nextafter(1.0, 2.0); }));
  EXPECT_TRUE(changed([](State& s) { s.links[0].X_WorldLink.rotation.w() = 0.5; }));
  EXPECT_TRUE(changed([](State& s) { s.links[0].v_WorldLink.x() = -0.0; }));
  EXPECT_TRUE(changed([](State& s) { s.links[0].w_WorldLink.y() = 1; }));
  EXPECT_TRUE(changed([](State& s) { s.joints[0].position = 1; }));
  EXPECT_TRUE(changed([](State& s) { s.joints[0].velocity = 1; }));
  EXPECT_TRUE(changed([](State& s) { s.joints[0].position2 = 1; }));
  EXPECT_TRUE(changed([](State& s) { s.joints[0].velocity2 = 1; }));
}

}  // namespace
}  // namespace pongsim::world
