#include "pongsim/actor.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <limits>
#include <string>
#include <vector>

#include "pongsim/scene.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "support/running_world.hh"

namespace pongsim {
namespace {

using test::RunningWorld;

constexpr const char* kActor = R"(<actor name="a"><pose>1 2 3 0 0 0</pose>
  <link name="l"><visual name="v"><geometry><sphere><radius>0.5</radius></sphere></geometry></visual></link>
  <script><trajectory id="0" type="walk"><waypoint><time>0</time><pose>0 0 0 0 0 0</pose></waypoint>
    <waypoint><time>1</time><pose>1 0 0 0 0 0</pose></waypoint></trajectory></script></actor>)";

class ActorTest : public testing::Test {
 protected:
  Actor actor() { return Actor::find(world_.simulation().world(), "a").value(); }
  RunningWorld world_{std::string(kActor)};
};

TEST_F(ActorTest, IsFoundByItsName) {
  EXPECT_EQ(actor().name(), "a");
  EXPECT_TRUE(actor().exists());
  EXPECT_FALSE(Actor::find(world_.simulation().world(), "b"));
  EXPECT_TRUE(actor().animations().empty());
  EXPECT_EQ(actor().startPose().position, Vector3(1, 2, 3));
}

TEST_F(ActorTest, GoesAlongItsScriptUntilItIsMoved) {
  world_.step(1000);
  EXPECT_NEAR(actor().pose().position.x(), 2, 1e-9);
  actor().move({{7, 8, 9}, Quaternion::Identity()});
  world_.step(500);
  EXPECT_EQ(actor().pose().position, Vector3(7, 8, 9));
  EXPECT_EQ(actor().startPose().position, Vector3(1, 2, 3));
  Diagnostics diagnostics;
  world_.simulation().reset(diagnostics);
  EXPECT_EQ(actor().pose().position, Vector3(1, 2, 3));
}

TEST_F(ActorTest, RefusesAPoseThatIsNotFinite) {
  testing::internal::CaptureStderr();
  actor().move({{std::numeric_limits<double>::quiet_NaN(), 0, 0}, Quaternion::Identity()});
  EXPECT_NE(testing::internal::GetCapturedStderr().find("actor 'a' was given a pose that is not finite"),
            std::string::npos);
  EXPECT_EQ(actor().pose().position, Vector3(1, 2, 3));
}

TEST_F(ActorTest, IsToldOfInTheStateWhereItWasMoved) {
  actor().move({{7, 8, 9}, Quaternion::Identity()}, "walk", std::chrono::milliseconds(3));
  ignition::msgs::SerializedStepMap step;
  Scene(world_.simulation().world()).fillInState(step, StateContent::kAll, false);
  std::vector<std::string> texts;
  for (const auto& [type, component] : step.state().entities().at(actor().id().value).components()) {
    texts.push_back(component.component());
  }
  for (const char* text : {"0 0 9 0 0 0", "7 8 0 0 0 0", "walk", "3000000"}) {
    EXPECT_NE(std::ranges::find(texts, text), texts.end()) << text;
  }
}

}  // namespace
}  // namespace pongsim
