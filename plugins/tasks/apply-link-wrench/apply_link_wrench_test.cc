#include <gtest/gtest.h>
#include <ignition/msgs/entity.pb.h>
#include <ignition/msgs/entity_wrench.pb.h>

#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::apply_link_wrench_test {
namespace {

using test::RunningWorld;

std::string persistent(const std::string& name, const std::string& type, const std::string& rest) {
  return "<persistent><entity_name>" + name + "</entity_name><entity_type>" + type + "</entity_type>" + rest +
         "</persistent>";
}

std::string worldWith(const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><model name="m"><link name="body"><inertial><mass>2</mass></inertial></link></model>
    <model name="n"><pose>9 0 0 0 0 1.5707963267948966</pose><link name="body"><inertial><mass>2</mass></inertial></link>
    </model><plugin filename="ignition-gazebo-apply-link-wrench-system"
                    name="ignition::gazebo::systems::ApplyLinkWrench">)" +
         parameters + "</plugin>";
}

TEST(ApplyLinkWrench, PushesModelsAndLinksInTheWorldFrame) {
  RunningWorld world(worldWith(persistent("m", "model", "<force>4 0 0</force>") +
                               persistent("n::body", "link", "<torque>0 0 1</torque>") +
                               persistent("n::body", "link", "<force>6 0 0</force>")));
  world.step(100);
  EXPECT_NEAR(world.model("m").canonicalLink()->linearVelocity().x(), 0.2, 1e-6);
  EXPECT_NEAR(world.model("n").canonicalLink()->linearVelocity().x(), 0.3, 1e-6);
  EXPECT_NEAR(world.model("n").canonicalLink()->angularVelocity().z(), 0.1, 1e-6);
}

TEST(ApplyLinkWrench, RefusesAWrenchThatCannotBeMeant) {
  for (const char* part : {"force", "torque"}) {
    const std::string element = std::string("<") + part + ">1e308 0 0</" + part + ">";
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(persistent("m", "model", element))),
              std::vector<std::string>{std::string("apply-link-wrench is left out: <") + part +
                                       "> of a wrench must be finite and from -1e8 to 1e8"});
  }
}

TEST(ApplyLinkWrench, EndsWhatIsCleared) {
  RunningWorld world(worldWith(persistent("m", "model", "<force>4 0 0</force>") +
                               persistent("n::body", "link", "<force>4 0 0</force>")));
  ignition::msgs::Entity entity;
  entity.set_name("n::body");
  entity.set_type(ignition::msgs::Entity::LINK);
  world.tell("/world/w/wrench/clear", entity);
  world.step(100);
  EXPECT_EQ(world.model("n").canonicalLink()->linearVelocity().x(), 0);
  EXPECT_NEAR(world.model("m").canonicalLink()->linearVelocity().x(), 0.2, 1e-6);
  entity.Clear();
  entity.set_id(world.model("m").id().value);
  world.tell("/world/w/wrench/clear", entity);
  world.step(100);
  EXPECT_NEAR(world.model("m").canonicalLink()->linearVelocity().x(), 0.2, 1e-6);
}

ignition::msgs::EntityWrench pull(const std::string& name, ignition::msgs::Entity::Type type, double force) {
  ignition::msgs::EntityWrench message;
  message.mutable_entity()->set_name(name);
  message.mutable_entity()->set_type(type);
  message.mutable_wrench()->mutable_force()->set_x(force);
  return message;
}

TEST(ApplyLinkWrench, AppliesAMessageForOneStep) {
  RunningWorld world(worldWith(""));
  world.tell("/world/w/wrench", pull("m", ignition::msgs::Entity::MODEL, 2000));
  world.tell("/world/w/wrench", pull("m::body", ignition::msgs::Entity::LINK, 2000));
  world.step(100);
  // 4 kN on 2 kg for 1 ms
  EXPECT_NEAR(world.model("m").canonicalLink()->linearVelocity().x(), 2, 1e-6);
}

TEST(ApplyLinkWrench, AppliesAMessageUntilItIsCleared) {
  RunningWorld world(worldWith("<topic_persistent>pull</topic_persistent>"));
  auto message = pull("", ignition::msgs::Entity::NONE, 4);
  message.mutable_entity()->set_id(world.model("m").id().value);
  world.tell("/pull", message);
  world.step(100);
  EXPECT_NEAR(world.model("m").canonicalLink()->linearVelocity().x(), 0.2, 1e-6);
  world.tell("/world/w/wrench/clear", message.entity());
  world.step(100);
  EXPECT_NEAR(world.model("m").canonicalLink()->linearVelocity().x(), 0.2, 1e-6);
}

TEST(ApplyLinkWrench, IgnoresMessagesThatMakeNoSense) {
  RunningWorld world(worldWith(""));
  testing::internal::CaptureStderr();
  world.tell("/world/w/wrench", pull("k", ignition::msgs::Entity::MODEL, 1));
  world.step(10);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("there is no link or model 'k' to apply a wrench to"), std::string::npos) << said;
  EXPECT_EQ(world.model("m").canonicalLink()->linearVelocity().x(), 0);
}

TEST(ApplyLinkWrench, RefusesAbsurdWrenchesAndGoesOn) {
  RunningWorld world(worldWith(""));
  const std::string text = "entity {name: 'm' type: MODEL} wrench {force {x: #}}";
  world.tellAbsurdities("/world/w/wrench", "ignition.msgs.EntityWrench", text, "1e+08");
  world.tellAbsurdities("/world/w/wrench/persistent", "ignition.msgs.EntityWrench", text, "1e+08");
  EXPECT_EQ(world.model("m").canonicalLink()->linearVelocity().x(), 0);
  world.tell("/world/w/wrench", pull("m", ignition::msgs::Entity::MODEL, 2000));
  world.tell("/world/w/wrench/persistent", pull("m", ignition::msgs::Entity::MODEL, 4));
  world.step(100);
  // 2 kN on 2 kg for 1 ms, 4 N for 100 ms
  EXPECT_NEAR(world.model("m").canonicalLink()->linearVelocity().x(), 1.2, 1e-6);
}

TEST(ApplyLinkWrench, IsLeftOutWithTheReason) {
  const std::string left = "apply-link-wrench is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(persistent("k", "model", ""))),
            std::vector<std::string>{left + "there is no model 'k'"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(persistent("m", "link", ""))),
            std::vector<std::string>{left + "there is no link 'm'"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(persistent("m", "joint", ""))),
            std::vector<std::string>{left + "<entity_type> 'joint' is neither 'link' nor 'model'"});
}

TEST(ApplyLinkWrench, OfFortressTestWorldPushes) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/apply_link_wrench.sdf");
  world.step(500);
  EXPECT_GT(world.model("model1").canonicalLink()->linearVelocity().x(), 0.1);
  EXPECT_LT(world.model("model2").canonicalLink()->linearVelocity().x(), -0.1);
}

}  // namespace
}  // namespace pongsim::apply_link_wrench_test
