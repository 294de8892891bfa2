#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "pongsim/files/urdf_source.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

constexpr const char* kWorldOfParts = R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity>
  <model name="outer"><pose>1 2 3 0 0 0</pose>
    <link name="base"><inertial><mass>2</mass></inertial>
      <visual name="look"><pose>0 0 4 0 0 0</pose><geometry><sphere/></geometry></visual>
      <collision name="skin"><pose>0 0 5 0 0 0</pose>
        <geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
      <sensor name="imu" type="imu"><pose>0 0 2 0 0 0</pose><update_rate>5</update_rate>
        <always_on>true</always_on></sensor></link>
    <model name="inner"><pose>0 0 1 0 0 0</pose><link name="arm"><inertial><mass>2</mass></inertial></link>
      <joint name="hinge" type="revolute"><parent>world</parent><child>arm</child>
        <axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>2</upper><effort>3</effort><velocity>4</velocity></limit>
          <dynamics><damping>5</damping><friction>6</friction></dynamics></axis></joint></model>
    <joint name="shaft" type="revolute"><pose>0 0 1 0 0 0</pose><parent>base</parent><child>inner::arm</child>
      <axis><xyz>0 0 1</xyz></axis>
      <sensor name="load" type="imu"><topic>t</topic><ignition_frame_id>f</ignition_frame_id></sensor></joint>
  </model></world></sdf>)";

class PartHandlesTest : public testing::Test {
 protected:
  PartHandlesTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kWorldOfParts, "world.sdf", {.loadSystems = false}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }
  Model outer() { return simulation_->world().model("outer").value(); }
  Link base() { return outer().link("base").value(); }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(PartHandlesTest, LeadFromALinkToItsPartsAndBack) {
  EXPECT_EQ(base().scopedName(), "outer::base");
  EXPECT_EQ(base().model().id(), outer().id());
  ASSERT_EQ(base().collisions().size(), 1U);
  const Collision skin = base().collisions()[0];
  EXPECT_EQ(skin.name(), "skin");
  EXPECT_EQ(skin.scopedName(), "outer::base::skin");
  EXPECT_EQ(skin.link().id(), base().id());
  EXPECT_EQ(skin.poseInLink().position, Vector3(0, 0, 5));
  EXPECT_EQ(simulation_->world().collision(skin.id())->name(), "skin");
  EXPECT_FALSE(simulation_->world().collision(CollisionId{base().id().value}).has_value());
  EXPECT_EQ(std::get<SphereShape>(skin.shape()).radius, 0.1);
  EXPECT_FALSE(skin.meshFile());
  EXPECT_EQ(skin.sourcePosition().line, 5);
  ASSERT_EQ(base().visuals().size(), 1U);
  EXPECT_EQ(base().visuals()[0].name(), "look");
  EXPECT_EQ(base().visuals()[0].poseInLink().position, Vector3(0, 0, 4));
  ASSERT_EQ(base().sensors().size(), 1U);
  EXPECT_EQ(base().sensors()[0].name(), "imu");
}

TEST_F(PartHandlesTest, TellWhereAJointIsInBothOfItsLinks) {
  const Joint shaft = outer().joint("shaft").value(), hinge = outer().joint("inner::hinge").value();
  EXPECT_EQ(shaft.poseInChild().position, Vector3(0, 0, 1));
  EXPECT_EQ(shaft.poseInParent().position, Vector3(0, 0, 2));
  // its parent is the world
  EXPECT_EQ(hinge.poseInParent().position, Vector3(1, 2, 4));
  EXPECT_EQ(hinge.friction(), 6);
  EXPECT_EQ(shaft.friction(), 0);
}

TEST(PartHandles, LeadToThePluginsOfAModelAndToItsUrdf) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><model name='m'><link name='l'/><model name='inner'><link name='l'/>"
      "<plugin filename='c' name='n'/></model><plugin filename='a' name='n'/><plugin filename='b' name='n'/></model>"
      "</world></sdf>",
      "w.sdf", {.loadSystems = false}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  const Model model = simulation->world().model("m").value();
  ASSERT_EQ(model.plugins().size(), 2U);
  EXPECT_EQ(model.plugins()[1]->attributeOr("filename", ""), "b");
  EXPECT_EQ(model.urdf(), nullptr);

  const std::string text =
      "<robot name='r'><link name='l'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' "
      "iyz='0'/></inertial></link><other/></robot>";
  const std::optional<Model> robot = simulation->insertText(text, "t", {}, diagnostics);
  ASSERT_TRUE(robot);
  ASSERT_NE(robot->urdf(), nullptr);
  EXPECT_EQ(robot->urdf()->text, text);
  EXPECT_NE(robot->urdf()->robot.child("other"), nullptr);
  const std::optional<Model> copy = simulation->insertCopy(*robot, {.name = "copy"}, diagnostics);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->urdf(), robot->urdf());
}

TEST_F(PartHandlesTest, LetASurfaceRunAlongAndSlip) {
  Collision skin = base().collisions()[0];
  EXPECT_EQ(skin.surfaceMotion(), std::nullopt);
  const SurfaceMotion motion{.speed = -2, .axis = {1, 0, 0}, .center = Vector3(1, 2, 3)};
  skin.setSurfaceMotion(motion);
  EXPECT_EQ(skin.surfaceMotion(), motion);
  for (const SurfaceMotion& bad :
       {SurfaceMotion{.speed = 1e308}, SurfaceMotion{.speed = NAN}, SurfaceMotion{.axis = Vector3::Zero()},
        SurfaceMotion{.center = Vector3(0, 0, INFINITY)}}) {
    skin.setSurfaceMotion(bad);
    EXPECT_EQ(skin.surfaceMotion(), motion);
  }
  skin.setSlip(0.25, 0.5);
  for (const double bad : {-1.0, double{NAN}, double{INFINITY}}) skin.setSlip(bad, 0);
  EXPECT_EQ(skin.slip(), std::pair(0.25, 0.5));

  // the state is saved, and discarded by a reset
  const std::vector<std::byte> state = simulation_->saveState();
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(skin.surfaceMotion(), std::nullopt);
  EXPECT_EQ(skin.slip(), std::pair(0.0, 0.0));
  ASSERT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(skin.surfaceMotion(), motion);
  EXPECT_EQ(skin.slip(), std::pair(0.25, 0.5));
}

TEST_F(PartHandlesTest, TellOfASensorOnALink) {
  const Sensor imu = base().sensors()[0];
  EXPECT_EQ(imu.type(), "imu");
  EXPECT_EQ(imu.scopedName(), "outer::base::imu");
  EXPECT_EQ(imu.link().id(), base().id());
  EXPECT_FALSE(imu.joint().has_value());
  EXPECT_EQ(imu.pose().position, Vector3(1, 2, 5));
  EXPECT_EQ(imu.topic("/imu"), "/world/w/model/outer/link/base/sensor/imu/imu");
  EXPECT_EQ(imu.frameName(), "outer::base::imu");
  EXPECT_EQ(imu.updateRate(), 5);
  EXPECT_TRUE(imu.isAlwaysOn());
  EXPECT_FALSE(imu.hasMetrics());
  EXPECT_NE(imu.settings<ImuSettings>(), nullptr);
  EXPECT_EQ(imu.sdf().name, "sensor");
  base().setVelocity({1, 0, 0}, {0, 3, 0});
  EXPECT_EQ(imu.linearVelocity(), Vector3(7, 0, 0));
}

TEST_F(PartHandlesTest, TellOfASensorOnAJoint) {
  const Sensor load = outer().joint("shaft")->sensors().at(0);
  EXPECT_EQ(load.scopedName(), "outer::shaft::load");
  EXPECT_EQ(load.joint()->name(), "shaft");
  EXPECT_EQ(load.link().name(), "arm");
  EXPECT_EQ(load.poseInLink().position, Vector3(0, 0, 1));
  EXPECT_EQ(load.topic("/imu"), "t");
  EXPECT_EQ(load.frameName(), "f");
  EXPECT_EQ(simulation_->world().sensors("imu").size(), 2U);
  EXPECT_TRUE(simulation_->world().sensors("camera").empty());
}

TEST_F(PartHandlesTest, TellOfAJointAndItsAxis) {
  const Joint hinge = outer().joint("inner::hinge").value();
  EXPECT_EQ(hinge.type(), "revolute");
  EXPECT_FALSE(hinge.parent().has_value());
  EXPECT_EQ(hinge.child().scopedName(), "outer::inner::arm");
  const JointAxisInfo axis = hinge.axisInfo();
  EXPECT_EQ(axis.xyz, Vector3::UnitY());
  EXPECT_EQ(axis.lower, -1);
  EXPECT_EQ(axis.upper, 2);
  EXPECT_EQ(axis.effort, 3);
  EXPECT_EQ(axis.velocity, 4);
  EXPECT_EQ(axis.damping, 5);
  EXPECT_EQ(outer().joint("shaft")->parent()->name(), "base");
  EXPECT_EQ(outer().joint("shaft")->poseInChild().position, Vector3(0, 0, 1));
}

// The reaction is the wrench on the child: the support of its weight, m g, and the motor's torque, I dw/dt.
TEST(JointReaction, IsWhatTheJointDoesToItsChild) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(R"(<sdf version="1.9"><world name="w"><model name="m">
      <link name="rotor"><inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>
      </link><joint name="axle" type="revolute"><parent>world</parent><child>rotor</child><axis><xyz>0 0 1</xyz></axis>
      </joint></model></world></sdf>)",
                                               "world.sdf", {}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  Joint axle = simulation->world().model("m")->joint("axle").value();
  EXPECT_EQ(axle.reaction().force, Vector3::Zero());
  axle.addForce(0.5);
  simulation->step();
  EXPECT_NEAR((axle.reaction().force - Vector3(0, 0, 2 * 9.8)).norm(), 0, 1e-3);
  EXPECT_NEAR((axle.reaction().torque - Vector3(0, 0, 0.5)).norm(), 0, 1e-3);
  simulation->step();
  EXPECT_NEAR(axle.reaction().torque.norm(), 0, 1e-3);
  axle.setVelocityTarget(axle.velocity() + 0.001);
  simulation->step();
  // I dw/dt = 0.1 kg m^2 * 0.001 rad/s / 0.001 s
  EXPECT_NEAR((axle.reaction().torque - Vector3(0, 0, 0.1)).norm(), 0, 1e-3);
}

TEST_F(PartHandlesTest, TellWhatAModelIsNestedIn) {
  EXPECT_EQ(simulation_->world().model("outer::inner")->parent()->id(), outer().id());
  EXPECT_FALSE(outer().parent().has_value());
}

TEST_F(PartHandlesTest, RefuseAVelocityThatIsNotFinite) {
  testing::internal::CaptureStderr();
  base().setVelocity({std::numeric_limits<double>::quiet_NaN(), 0, 0}, Vector3::Zero());
  outer().setVelocity(Vector3::Zero(), {0, 0, std::numeric_limits<double>::infinity()});
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("link 'base' was given a velocity that is not finite"), std::string::npos) << said;
  EXPECT_NE(said.find("model 'outer' was given a velocity that is not finite"), std::string::npos) << said;
  EXPECT_EQ(base().linearVelocity(), Vector3::Zero());
}

// The model moves as a rigid body; the joints keep their relative velocities.
TEST(ModelVelocity, LeavesTheJointsTheirs) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity>
    <model name="m"><link name="hub"><inertial><mass>2</mass></inertial></link>
      <link name="wheel"><pose>1 0 0 0 0 0</pose><inertial><mass>2</mass></inertial></link>
      <joint name="axle" type="revolute"><parent>hub</parent><child>wheel</child><axis><xyz>1 0 0</xyz></axis></joint>
    </model></world></sdf>)",
                                               "world.sdf", {}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  Model model = simulation->world().model("m").value();
  Link wheel = model.link("wheel").value();
  wheel.setVelocity(Vector3::Zero(), {5, 0, 0});
  model.setVelocity({0, 0, 1}, {0, 0, 2});
  EXPECT_EQ(wheel.linearVelocity(), Vector3(0, 2, 1));
  EXPECT_EQ(wheel.angularVelocity(), Vector3(5, 0, 2));
  simulation->step();
  EXPECT_NEAR(model.joint("axle")->velocity(), 5, 1e-3);
  EXPECT_NEAR(model.pose().position.z(), 0.001, 1e-6);
}

}  // namespace
}  // namespace pongsim
