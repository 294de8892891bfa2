#include "pongsim/handles.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/sensing/sensor.hh"
#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

constexpr const char* kWorld = R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity>
  <wind><linear_velocity>1 2 3</linear_velocity></wind>
  <frame name="dock"><pose>4 0 0 0 0 0</pose></frame>
  <frame name="hand" attached_to="arm::upper"><pose relative_to="arm::upper">0 0 5 0 0 0</pose></frame>
  <model name="base"><static>true</static><link name="ground"/></model>
  <model name="arm" canonical_link="upper"><pose>1 2 3 0 0 0</pose>
    <link name="upper"><enable_wind>true</enable_wind><pose>0 0 1 0 0 0</pose><inertial><mass>2</mass></inertial></link>
    <link name="lower"><pose>0 0 2 0 0 0</pose><inertial><mass>2</mass></inertial></link>
    <joint name="elbow" type="revolute"><parent>upper</parent><child>lower</child><axis><xyz>0 0 1</xyz></axis></joint>
    <joint name="knot" type="ball"><parent>upper</parent><child>lower</child></joint>
  </model>
  <model name="kite"><pose>0 9 0 0 0 0</pose><enable_wind>true</enable_wind>
    <link name="sail"><inertial><pose>0 0 0 0 0 1</pose></inertial></link>
    <link name="weight"><pose>0 0 -1 0 0 0</pose><enable_wind>false</enable_wind></link>
  </model></world></sdf>)";

class HandlesTest : public testing::Test {
 protected:
  HandlesTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kWorld, "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }
  World world() { return simulation_->world(); }
  Model arm() { return world().model("arm").value(); }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(HandlesTest, LeadFromTheWorldToItsParts) {
  EXPECT_EQ(world().name(), "w");
  EXPECT_EQ(world().gravity(), Vector3::Zero());
  ASSERT_EQ(world().models().size(), 3U);
  EXPECT_EQ(world().models()[1].name(), "arm");
  EXPECT_EQ(arm().scopedName(), "arm");
  EXPECT_TRUE(world().model("base")->isStatic());
  EXPECT_FALSE(arm().isStatic());
  EXPECT_EQ(arm().links().size(), 2U);
  EXPECT_EQ(arm().joints().size(), 2U);
  EXPECT_EQ(arm().canonicalLink()->name(), "upper");
  EXPECT_EQ(arm().joint("elbow")->name(), "elbow");
}

TEST_F(HandlesTest, FindNothingUnderAWrongName) {
  EXPECT_FALSE(world().model("leg").has_value());
  EXPECT_FALSE(arm().link("middle").has_value());
  EXPECT_FALSE(arm().joint("knee").has_value());
}

TEST_F(HandlesTest, GiveEveryEntityANumberOfItsOwn) {
  EXPECT_NE(arm().id().value, world().model("base")->id().value);
  EXPECT_NE(arm().link("upper")->id(), arm().link("lower")->id());
  EXPECT_NE(arm().joint("elbow")->id().value, arm().link("lower")->id().value);
}

TEST_F(HandlesTest, GivePosesInTheWorldFrame) {
  EXPECT_EQ(arm().pose().position, Vector3(1, 2, 3));
  EXPECT_EQ(arm().link("lower")->pose().position, Vector3(1, 2, 5));
  EXPECT_EQ(arm().link("lower")->linearVelocity(), Vector3::Zero());
}

TEST_F(HandlesTest, ApplyAWrenchDuringOneStep) {
  Link upper = arm().canonicalLink().value();
  const double mass = 4;  // both links
  upper.addWrench({0, 0, 8}, Vector3::Zero());
  simulation_->step(10);
  EXPECT_NEAR(upper.linearVelocity().z(), 8 / mass * 0.001, 1e-6);
}

TEST_F(HandlesTest, CountOnlyAxesThatHaveAPosition) {
  EXPECT_EQ(arm().joint("elbow")->axisCount(), 1);
  EXPECT_EQ(arm().joint("knot")->axisCount(), 0);
  EXPECT_EQ(arm().joint("knot")->position(), 0);
}

TEST_F(HandlesTest, ChangeTheRealTimeFactor) {
  EXPECT_EQ(world().realTimeFactor(), 1);
  EXPECT_TRUE(world().setRealTimeFactor(0));
  EXPECT_EQ(simulation_->realTimeFactor(), 0);
  EXPECT_TRUE(world().setRealTimeFactor(2.5));
  for (const double factor : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(world().setRealTimeFactor(factor).error, "a real-time factor must be zero or more");
  }
  EXPECT_EQ(simulation_->realTimeFactor(), 2.5);
}

TEST_F(HandlesTest, ChangeTheWind) {
  EXPECT_EQ(world().wind(), Vector3(1, 2, 3));
  EXPECT_TRUE(world().setWind({-4, 5, 6}));
  EXPECT_EQ(world().wind(), Vector3(-4, 5, 6));
  for (const double speed : {1e6, 1e308, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(world().setWind({speed, 0, speed}).error, "the wind can't be faster than 10000 m/s");
  }
  EXPECT_EQ(world().wind(), Vector3(-4, 5, 6));
  const std::vector<std::byte> state = simulation_->saveState();
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(world().wind(), Vector3(1, 2, 3));
  EXPECT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(world().wind(), Vector3(-4, 5, 6));
}

TEST_F(HandlesTest, TellWhatTheWindMoves) {
  EXPECT_TRUE(arm().link("upper")->isInWind());
  EXPECT_FALSE(arm().link("lower")->isInWind());
  EXPECT_TRUE(world().model("kite")->link("sail")->isInWind());
  // as in Fortress
  EXPECT_TRUE(world().model("kite")->link("weight")->isInWind());
}

TEST_F(HandlesTest, TellTheAxesOfAnInertia) {
  EXPECT_TRUE(arm().link("upper")->mass().axes.isApprox(Quaternion::Identity()));
  EXPECT_TRUE(world().model("kite")->link("sail")->mass().axes.isApprox(fromRollPitchYaw(0, 0, 1)));
}

TEST_F(HandlesTest, LetGoOfAVelocityTarget) {
  Joint elbow = arm().joint("elbow").value();
  const auto push = [&] {
    for (int i = 0; i < 100; ++i) {
      elbow.addForce(1);
      simulation_->step();
    }
  };
  elbow.setVelocityTarget(0);
  push();
  EXPECT_NEAR(elbow.velocity(), 0, 1e-6);
  elbow.clearVelocityTarget();
  push();
  // d_omega = torque * time / inertia = 1 N m * 0.1 s / (1 kg m^2) for each of the two links, in opposite directions
  EXPECT_NEAR(elbow.velocity(), 0.2, 0.01);
}

TEST_F(HandlesTest, PassWhatActuatorsAreTold) {
  EXPECT_EQ(arm().actuators(), nullptr);
  const std::vector<double> speeds{1, -2, 3};
  arm().setActuators(speeds);
  ASSERT_NE(arm().actuators(), nullptr);
  EXPECT_EQ(*arm().actuators(), speeds);
  EXPECT_EQ(world().model("kite")->actuators(), nullptr);
  arm().setActuators(std::vector<double>{std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(*arm().actuators(), speeds);

  const std::vector<std::byte> state = simulation_->saveState();
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(arm().actuators(), nullptr);
  EXPECT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(*arm().actuators(), speeds);
  const Model removed = arm();
  EXPECT_TRUE(simulation_->remove(removed));
  EXPECT_EQ(removed.actuators(), nullptr);
  EXPECT_THROW(Model(removed).setActuators(speeds), Gone);
}

TEST_F(HandlesTest, TellWhereTheFramesOfTheWorldAre) {
  const Model model = arm();
  EXPECT_TRUE(Model(model).setPose({{0, 0, 0}, fromRollPitchYaw(0, 0, 1)}));
  const std::vector<WorldFrame> frames = world().frames();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].name, "dock");
  EXPECT_TRUE(frames[0].pose.position.isApprox(Vector3(4, 0, 0)));
  EXPECT_EQ(frames[1].name, "hand");
  EXPECT_TRUE(frames[1].pose.position.isApprox(Vector3(0, 0, 6)));
  EXPECT_NEAR(yawOf(frames[1].pose.rotation), 1, 1e-12);

  // an inserted model of that name is not the one to which the frame is attached
  EXPECT_TRUE(simulation_->remove(arm()));
  EXPECT_EQ(world().frames().size(), 1U);
  Diagnostics diagnostics;
  simulation_->insertText("<sdf version='1.9'><model name='arm'><link name='upper'/></model></sdf>", "arm", {},
                          diagnostics);
  EXPECT_EQ(world().frames().size(), 1U);
}

TEST_F(HandlesTest, TellWhatCameSinceTheStart) {
  Diagnostics diagnostics;
  const auto inserted = simulation_->insertText(
      "<sdf version='1.9'><model name='new'><model name='in'><link name='l'/></model></model></sdf>", "new", {},
      diagnostics);
  ASSERT_TRUE(inserted.has_value());
  EXPECT_TRUE(inserted->isInserted());
  EXPECT_TRUE(world().model("new::in")->isInserted());
  EXPECT_FALSE(arm().isInserted());
  EXPECT_FALSE(world().isNameFree("new"));
  EXPECT_FALSE(world().isNameFree("arm"));
  EXPECT_TRUE(world().isNameFree("newer"));
}

TEST_F(HandlesTest, PutTopicsOfAnInsertedModelIntoItsNamespace) {
  constexpr const char* kCar =
      "<sdf version='1.9'><model name='car'><link name='l'>"
      "<sensor name='a' type='imu'/><sensor name='b' type='imu'><topic>b</topic></sensor></link>"
      "<plugin filename='ignition-gazebo-imu-system' name='ignition::gazebo::systems::Imu'/>"
      "<plugin filename='ignition-gazebo-velocity-control-system' name='ignition::gazebo::systems::VelocityControl'>"
      "<topic>/cmd_vel</topic></plugin></model></sdf>";
  Diagnostics diagnostics;
  const auto car = simulation_->insertText(kCar, "car", {.nameSpace = "/r1"}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  ASSERT_TRUE(car.has_value());
  const std::vector<Sensor> sensors = car->link("l")->sensors();
  EXPECT_EQ(sensors[0].topic("/imu"), "/r1/world/w/model/car/link/l/sensor/a/imu");
  EXPECT_EQ(sensors[1].topic("/imu"), "/r1/b");
  const std::vector<OwnTopic> topics = simulation_->transport().node().ownTopics();
  EXPECT_TRUE(std::ranges::any_of(topics, [](const OwnTopic& topic) { return topic.name == "/r1/cmd_vel"; }));

  EXPECT_FALSE(simulation_->insertText(kCar, "car", {.name = "c", .nameSpace = "/a b"}, diagnostics).has_value());
  EXPECT_NE(diagnostics.all().back().message.find("the namespace '/a b' "), std::string::npos);
}

TEST_F(HandlesTest, RefuseCommandsThatMakeNoSense) {
  const std::uint64_t before = [&] {
    simulation_->step(5);
    return simulation_->stateHash();
  }();
  testing::internal::CaptureStderr();
  arm().joint("knot")->setVelocityTarget(1);
  arm().joint("elbow")->setVelocityTarget(std::numeric_limits<double>::quiet_NaN());
  arm().joint("elbow")->addForce(std::numeric_limits<double>::infinity());
  arm().joint("elbow")->addForce(1, 3);
  arm().canonicalLink()->addWrench({0, 0, std::numeric_limits<double>::quiet_NaN()}, Vector3::Zero());
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("joint 'knot' has no axis 0 to command"), std::string::npos) << said;
  EXPECT_NE(said.find("joint 'elbow' was given a command that is not a finite number"), std::string::npos) << said;
  EXPECT_NE(said.find("joint 'elbow' has no axis 3 to command"), std::string::npos) << said;
  EXPECT_NE(said.find("link 'upper' was given a wrench that is not finite"), std::string::npos) << said;
  EXPECT_EQ(simulation_->stateHash(), before);
}

TEST_F(HandlesTest, RefuseCommandsBeyondAllMeasure) {
  simulation_->step(5);
  const std::uint64_t before = simulation_->stateHash();
  testing::internal::CaptureStderr();
  arm().joint("elbow")->setVelocityTarget(1e9);
  arm().joint("elbow")->addForce(-1e308);
  arm().canonicalLink()->addWrench({0, 0, 1e11}, Vector3::Zero());
  arm().canonicalLink()->setVelocity({0, 1e9, 0}, Vector3::Zero());
  arm().setVelocity(Vector3::Zero(), {0, 1e9, 0});
  const std::string said = testing::internal::GetCapturedStderr();
  for (const char* part : {"joint 'elbow' was given a command beyond 1e8 m/s or rad/s",
                           "joint 'elbow' was given a command beyond 1e10 N or N m",
                           "link 'upper' was given a wrench that is not finite or beyond 1e10 N or N m",
                           "link 'upper' was given a velocity that is not finite or beyond 1e8 m/s or rad/s",
                           "model 'arm' was given a velocity that is not finite or beyond 1e8 m/s or rad/s"}) {
    EXPECT_NE(said.find(part), std::string::npos) << part << "\n" << said;
  }
  EXPECT_EQ(simulation_->stateHash(), before);
}

}  // namespace
}  // namespace pongsim
