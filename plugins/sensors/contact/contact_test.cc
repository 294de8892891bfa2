#include <gtest/gtest.h>
#include <ignition/msgs/contacts.pb.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::contact_test {
namespace {

/// A plate of half a metre's thickness, and a ball that lies on it with its lowest point at that height.
std::string worldWith(const std::string& contact, double height) {
  return R"(<sdf version="1.9"><world name="w">
    <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
    <plugin filename="ignition-gazebo-contact-system" name="ignition::gazebo::systems::Contact"/>
    <model name="ball"><pose>0 0 )" +
         std::to_string(height + 0.1) + R"( 0 0 0</pose><link name="body"><inertial><mass>2</mass></inertial>
      <collision name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision></link></model>
    <model name="plate"><static>true</static><link name="slab">
      <collision name="aside"><pose>9 0 0 0 0 0</pose><geometry><box><size>1 1 1</size></box></geometry></collision>
      <collision name="top"><geometry><box><size>1 1 1</size></box></geometry></collision>
      <sensor name="feeler" type="contact"><update_rate>1</update_rate><contact>)" +
         contact + "</contact></sensor></link></model></world></sdf>";
}

class ContactTest : public testing::Test {
 protected:
  void load(const std::string& world) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(world, "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
  }
  void listen(const std::string& topic) {
    subscription_ = simulation_->transport().node().subscribe<ignition::msgs::Contacts>(
        topic, [this](const auto& message) { received_.push_back(message); });
  }
  void step(std::uint64_t count) {
    simulation_->step(count);
    simulation_->transport().dispatch();
  }

  std::unique_ptr<Simulation> simulation_;
  std::vector<ignition::msgs::Contacts> received_;
  Subscription subscription_;
};

constexpr const char* kDefaultTopic = "/world/w/model/plate/link/slab/sensor/feeler/contact";

TEST_F(ContactTest, TellsWhoTouchesWhereAndHowHard) {
  load(worldWith("<collision>top</collision>", 0.5));
  listen(kDefaultTopic);
  step(500);
  ASSERT_FALSE(received_.empty());
  const ignition::msgs::Contacts& last = received_.back();
  EXPECT_EQ(last.header().stamp().nsec(), 500'000'000);
  ASSERT_EQ(last.contact_size(), 1);
  const ignition::msgs::Contact& contact = last.contact(0);
  EXPECT_EQ(contact.header().stamp().nsec(), 500'000'000);
  // the sensor's own first, though it has the larger id
  EXPECT_EQ(contact.collision1().name(), "plate::slab::top");
  EXPECT_EQ(contact.collision2().name(), "ball::body::skin");
  EXPECT_EQ(contact.collision2().id(), simulation_->world().model("ball")->link("body")->collisions().at(0).id().value);
  ASSERT_EQ(contact.position_size(), 1);
  ASSERT_EQ(contact.normal_size(), 1);
  ASSERT_EQ(contact.depth_size(), 1);
  ASSERT_EQ(contact.wrench_size(), 1);
  EXPECT_NEAR(contact.position(0).z(), 0.5, 1e-3);
  EXPECT_NEAR(contact.normal(0).z(), -1, 1e-6);
  EXPECT_GE(contact.depth(0), 0);
  EXPECT_LT(contact.depth(0), 1e-3);
  EXPECT_EQ(contact.wrench(0).body_1_name(), "plate::slab");
  EXPECT_EQ(contact.wrench(0).body_2_name(), "ball::body");
  EXPECT_NEAR(contact.wrench(0).body_1_wrench().force().z(), -2 * 9.8, 1e-3);
  EXPECT_NEAR(contact.wrench(0).body_2_wrench().force().z(), 2 * 9.8, 1e-3);
}

TEST_F(ContactTest, SpeaksInEachStepWithAContactOnly) {
  load(worldWith("<collision>top</collision><topic>felt</topic>", 0.6));
  listen("/felt");
  // 0.1 m of fall take 143 ms
  step(142);
  EXPECT_TRUE(received_.empty());
  step(858);
  const std::size_t before = received_.size();
  EXPECT_GT(before, 500U);
  step(10);
  EXPECT_EQ(received_.size(), before + 10);
}

TEST_F(ContactTest, SaysNothingOfCollisionsThatItDoesNotWatch) {
  load(worldWith("<collision>aside</collision>", 0.5));
  listen(kDefaultTopic);
  step(100);
  EXPECT_TRUE(received_.empty());
}

TEST_F(ContactTest, WarnsOfACollisionThatIsNotThere) {
  Diagnostics diagnostics;
  Simulation::fromText(worldWith("<collision>bottom</collision>", 0.5), "world.sdf", {}, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all()[0].message,
            "sensor 'plate::slab::feeler' names collision 'bottom', which is not in link 'plate::slab'");
  EXPECT_GT(diagnostics.all()[0].position.line, 0);
}

TEST_F(ContactTest, OfFortressExampleSpeaksOnItsTopic) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  Diagnostics diagnostics;
  simulation_ = Simulation::fromFile(*worlds / "examples/contact_sensor.sdf", {}, diagnostics);
  ASSERT_NE(simulation_, nullptr);
  listen("/contact_example");
  step(3000);
  ASSERT_FALSE(received_.empty());
  EXPECT_EQ(received_.back().contact_size(), 1);
  EXPECT_EQ(received_.back().contact(0).position_size(), 1);
}

}  // namespace
}  // namespace pongsim::contact_test
