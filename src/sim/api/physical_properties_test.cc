#include "pongsim/physical_properties.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

// a box of 2 kg slides on a plane; a rod hangs on the world
constexpr const char* kSlidingBox = R"(<sdf version="1.9"><world name="w"><gravity>0 0 -10</gravity>
  <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry></collision>
  </link></model>
  <model name="box"><pose>0 0 0.5 0 0 0</pose><link name="l"><inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>2</iyy>
    <izz>2.5</izz></inertia></inertial><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision>
  </link></model>
  <model name="rod"><pose>5 0 5 0 0 0</pose><link name="l"/><joint name="j" type="revolute"><parent>world</parent>
    <child>l</child><axis><xyz>0 0 1</xyz></axis></joint></model>
</world></sdf>)";

constexpr const char* kBall = R"(<sdf version="1.9"><model name="ball"><pose>3 0 0.1 0 0 0</pose><link name="l">
  <collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
  <visual name="v"><geometry><sphere><radius>0.1</radius></sphere></geometry></visual>
  <visual name="w"><pose>0 0 1 0 0 0</pose><geometry><sphere><radius>0.1</radius></sphere></geometry></visual></link>
</model></sdf>)";
constexpr const char* kDumbbell = R"(<sdf version="1.9"><model name="dumbbell"><pose>5 5 1 0 0 0</pose><link name="l">
  <collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
  <collision name="d"><pose>1 0 0 0 0 0</pose><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
</link></model></sdf>)";

class PhysicalPropertiesTest : public testing::Test {
 protected:
  PhysicalPropertiesTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kSlidingBox, "world.sdf", {.loadSystems = false}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }
  Link box() { return simulation_->world().model("box")->link("l").value(); }
  Collision skin() { return box().collisions().front(); }
  Joint joint() { return simulation_->world().model("rod")->joint("j").value(); }
  PhysicalProperties properties() { return PhysicalProperties(simulation_->world()); }
  /// @return The speed that is left of 1 m/s after 100 steps on the plane.
  double slide() {
    box().setVelocity({1, 0, 0}, {0, 0, 0});
    simulation_->step(100);
    return box().linearVelocity().x();
  }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(PhysicalPropertiesTest, AMassActsAndIsTold) {
  ASSERT_TRUE(properties().setMass(box(), 4, 3));
  EXPECT_EQ(box().mass().mass, 4);
  EXPECT_EQ(box().mass().inertia.diagonal(), Vector3(3, 6, 7.5));
  EXPECT_EQ(properties().inertiaFactor(box()), 3);
  simulation_->world().setGravity(Vector3::Zero());
  box().addWrench({8, 0, 0}, {0, 0, 7.5});
  simulation_->step();
  EXPECT_NEAR(box().linearVelocity().x(), 0.002, 1e-12);
  EXPECT_NEAR(box().angularVelocity().z(), 0.001, 1e-12);
}

TEST_F(PhysicalPropertiesTest, AMassMustSuitTheAddedMass) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      "<sdf version='1.10'><world name='w'><model name='m'><link name='l'><inertial><mass>2</mass><fluid_added_mass>"
      "<xx>-1</xx></fluid_added_mass></inertial></link></model></world></sdf>",
      "world.sdf", {.loadSystems = false}, diagnostics);
  const Link link = simulation->world().model("m")->link("l").value();
  PhysicalProperties properties(simulation->world());
  const Outcome<void> refused = properties.setMass(link, 1, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error,
            "with this mass and inertia, link 'm::l' and its fluid_added_mass have no positive definite inertia");
  EXPECT_EQ(link.mass().mass, 2);
  EXPECT_TRUE(properties.setMass(link, 1.5, 1));
}

TEST_F(PhysicalPropertiesTest, FrictionActsOnContactsThatAreThere) {
  simulation_->step(50);
  ASSERT_TRUE(properties().setSurface(skin(), {0, 0, 0}));
  EXPECT_NEAR(slide(), 1, 1e-6);
  ASSERT_TRUE(properties().setSurface(skin(), {0.5, 0.5, 0}));
  EXPECT_NEAR(slide(), 0.5, 0.01);
  EXPECT_EQ(properties().surface(skin()).friction, 0.5);
}

TEST_F(PhysicalPropertiesTest, DampingAndFrictionOfAJoint) {
  ASSERT_TRUE(joint().resetVelocity(1));
  ASSERT_TRUE(properties().setDamping(joint(), 2));
  ASSERT_TRUE(properties().setFriction(joint(), 0.5));
  EXPECT_EQ(joint().axisInfo().damping, 2);
  EXPECT_EQ(joint().friction(), 0.5);
  simulation_->step(100);
  EXPECT_LT(joint().velocity(), 0.9);
}

TEST_F(PhysicalPropertiesTest, BoundsOfAJoint) {
  const PhysicalProperties::Bounds ofFile = properties().bounds(joint());
  joint().setVelocityTarget(1);
  simulation_->step(100);
  EXPECT_NEAR(joint().velocity(), 1, 1e-6);
  const std::vector<std::byte> free = simulation_->saveState();
  const double stuck = joint().position();
  // locked against a motor without a limit
  ASSERT_TRUE(properties().setBounds(joint(), {stuck, stuck, ofFile.effort}));
  joint().setVelocityTarget(1);
  simulation_->step(500);
  EXPECT_NEAR(joint().position(), stuck, 1e-4);
  const std::vector<std::byte> locked = simulation_->saveState();
  // a state from before has the file's again
  ASSERT_TRUE(simulation_->restoreState(free));
  EXPECT_EQ(properties().bounds(joint()).upper, ofFile.upper);
  simulation_->step(100);
  EXPECT_GT(joint().position(), stuck + 0.05);
  ASSERT_TRUE(simulation_->restoreState(locked));
  EXPECT_EQ(properties().bounds(joint()).upper, stuck);
  EXPECT_EQ(properties().bounds(joint()).effort, ofFile.effort);
  ASSERT_TRUE(properties().setBounds(joint(), {ofFile.lower, ofFile.upper, 0}));
  joint().setVelocityTarget(5);
  simulation_->step(100);
  EXPECT_NEAR(joint().velocity(), 0, 0.1);
}

TEST_F(PhysicalPropertiesTest, OfAStateReplaceThoseThatHaveChangedSince) {
  const std::vector<std::byte> plain = simulation_->saveState();
  ASSERT_TRUE(properties().setDamping(joint(), 2));
  ASSERT_TRUE(properties().setFriction(joint(), 3));
  ASSERT_TRUE(simulation_->restoreState(plain));
  EXPECT_EQ(joint().axisInfo().damping, 0);
  EXPECT_EQ(joint().friction(), 0);
  EXPECT_EQ(simulation_->saveState(), plain);
}

TEST_F(PhysicalPropertiesTest, AreSavedAndReset) {
  const std::vector<std::byte> plain = simulation_->saveState();
  ASSERT_TRUE(properties().setMass(box(), 4, 3));
  ASSERT_TRUE(properties().setSurface(skin(), {0.25, 0.125, 0.5}));
  ASSERT_TRUE(properties().setDamping(joint(), 2));
  slide();
  const std::vector<std::byte> state = simulation_->saveState();
  slide();
  const std::uint64_t expected = simulation_->stateHash();
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(simulation_->saveState(), plain);
  EXPECT_EQ(box().mass().mass, 2);
  ASSERT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(simulation_->saveState(), state);
  EXPECT_EQ(box().mass().mass, 4);
  EXPECT_EQ(properties().surface(skin()).friction2, 0.125);
  slide();
  EXPECT_EQ(simulation_->stateHash(), expected);
}

TEST_F(PhysicalPropertiesTest, RefuseWhatIsImpossible) {
  const std::vector<std::byte> before = simulation_->saveState();
  for (const double bad : {0.0, -1.0, double{NAN}, double{INFINITY}, 1e13}) {
    EXPECT_FALSE(properties().setMass(box(), bad, 1)) << bad;
    EXPECT_FALSE(properties().setMass(box(), 1, bad)) << bad;
  }
  for (const double bad : {-1.0, double{NAN}, double{INFINITY}, 1e13}) {
    EXPECT_FALSE(properties().setSurface(skin(), {bad, 1, 0})) << bad;
    EXPECT_FALSE(properties().setSurface(skin(), {1, bad, 0})) << bad;
    EXPECT_FALSE(properties().setDamping(joint(), bad)) << bad;
    EXPECT_FALSE(properties().setFriction(joint(), bad)) << bad;
  }
  EXPECT_FALSE(properties().setSurface(skin(), {1, 1, 1.5}));
  EXPECT_FALSE(properties().setDamping(joint(), 1, 1));
  EXPECT_FALSE(properties().setBounds(joint(), {0, 0, 1}, 1));
  EXPECT_FALSE(properties().setBounds(joint(), {1, 0, 1}));
  EXPECT_FALSE(properties().setBounds(joint(), {NAN, NAN, 1}));
  EXPECT_FALSE(properties().setBounds(joint(), {0, 0, -1}));
  EXPECT_FALSE(properties().setMass(simulation_->world().model("ground")->link("l").value(), 1, 1));
  EXPECT_EQ(simulation_->saveState(), before);
}

TEST_F(PhysicalPropertiesTest, ASizeActsOnWhatTouches) {
  simulation_->step(50);
  EXPECT_EQ(properties().size(skin()), std::vector<double>({1, 1, 1}));
  ASSERT_TRUE(properties().setSize(skin(), std::array{1.0, 1.0, 1.02}, {}));
  EXPECT_EQ(properties().size(skin()), std::vector<double>({1, 1, 1.02}));
  EXPECT_EQ(std::get<BoxShape>(skin().shape()).size, Vector3(1, 1, 1.02));
  EXPECT_EQ(box().mass().mass, 2);
  // pushed out of the ground at 1 cm/s
  simulation_->step(3000);
  EXPECT_NEAR(box().pose().position.z(), 0.51, 1e-3);
  ASSERT_TRUE(properties().setSize(skin(), std::array{1.0, 1.0, 0.2}, {}));
  simulation_->step(1000);
  EXPECT_NEAR(box().pose().position.z(), 0.1, 1e-3);
}

TEST_F(PhysicalPropertiesTest, AMassFollowsASizeAtTheSameDensity) {
  ASSERT_TRUE(properties().setMass(box(), 4, 2));
  ASSERT_TRUE(properties().setSize(skin(), std::array{2.0, 1.0, 3.0}, {.mass = true}));
  EXPECT_DOUBLE_EQ(box().mass().mass, 24);
  // the integrals of x^2, y^2, z^2 that belong to twice (1, 2, 2.5)
  const Vector3 before(3.5, 1.5, 0.5), after = 6 * before.cwiseProduct(Vector3(4, 1, 9));
  EXPECT_TRUE(box().mass().inertia.diagonal().isApprox(
      Vector3(after.y() + after.z(), after.x() + after.z(), after.x() + after.y())));
  // and back
  ASSERT_TRUE(properties().setSize(skin(), std::array{1.0, 1.0, 1.0}, {.mass = true}));
  EXPECT_TRUE(box().mass().inertia.diagonal().isApprox(Vector3(2, 4, 5)));
  simulation_->world().setGravity(Vector3::Zero());
  box().addWrench({4, 0, 0}, {0, 0, 5});
  simulation_->step();
  EXPECT_NEAR(box().linearVelocity().x(), 0.001, 1e-12);
  EXPECT_NEAR(box().angularVelocity().z(), 0.001, 1e-12);
}

TEST_F(PhysicalPropertiesTest, SizesAreSavedAndReset) {
  const std::vector<std::byte> plain = simulation_->saveState();
  ASSERT_TRUE(properties().setSize(skin(), std::array{2.0, 1.0, 3.0}, {.mass = true}));
  slide();
  const std::vector<std::byte> state = simulation_->saveState();
  slide();
  const std::uint64_t expected = simulation_->stateHash();
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(simulation_->saveState(), plain);
  EXPECT_EQ(properties().size(skin()), std::vector<double>({1, 1, 1}));
  ASSERT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(simulation_->saveState(), state);
  EXPECT_EQ(properties().size(skin()), std::vector<double>({2, 1, 3}));
  slide();
  EXPECT_EQ(simulation_->stateHash(), expected);
  ASSERT_TRUE(simulation_->restoreState(plain));
  EXPECT_EQ(simulation_->saveState(), plain);
  EXPECT_EQ(properties().size(skin()), std::vector<double>({1, 1, 1}));
}

TEST_F(PhysicalPropertiesTest, SizesOfWhatComesAndGoes) {
  Diagnostics diagnostics;
  const auto ball = simulation_->insertText(kBall, "ball.sdf", {}, diagnostics);
  ASSERT_TRUE(ball);
  const Collision skin = ball->link("l")->collisions().front();
  ASSERT_TRUE(properties().setSize(skin, std::array{0.11}, {}));
  simulation_->step(2000);
  EXPECT_NEAR(ball->link("l")->pose().position.z(), 0.11, 1e-3);
  ASSERT_TRUE(simulation_->remove(*ball));
  simulation_->step(10);
  EXPECT_THROW(static_cast<void>(properties().setSize(skin, std::array{1.0}, {})), Gone);
  simulation_->reset(diagnostics);
  simulation_->step(10);
}

TEST_F(PhysicalPropertiesTest, VisualsFollowOrHaveASizeOfTheirOwn) {
  Diagnostics diagnostics;
  const auto ball = simulation_->insertText(kBall, "ball.sdf", {}, diagnostics);
  const Link link = ball->link("l").value();
  const Collision skin = link.collisions().front();
  const std::vector<Visual> visuals = link.visuals();
  ASSERT_EQ(visuals.size(), 2U);
  ASSERT_TRUE(properties().setSize(skin, std::array{0.5}, {}));
  EXPECT_EQ(properties().size(link, visuals[0]), std::vector{0.5});
  EXPECT_EQ(properties().size(link, visuals[1]), std::vector{0.1});
  ASSERT_TRUE(properties().setSize(link, visuals[1], std::array{0.3}));
  ASSERT_TRUE(properties().setSize(skin, std::array{0.7}, {.visuals = false}));
  EXPECT_EQ(properties().size(link, visuals[0]), std::vector{0.5});
  EXPECT_EQ(properties().size(link, visuals[1]), std::vector{0.3});
}

TEST_F(PhysicalPropertiesTest, RefuseSizesThatAreImpossible) {
  const std::vector<std::byte> before = simulation_->saveState();
  for (const double bad : {0.0, -1.0, double{NAN}, double{INFINITY}, 1e13}) {
    EXPECT_FALSE(properties().setSize(skin(), std::array{1.0, bad, 1.0}, {})) << bad;
  }
  EXPECT_EQ(properties().setSize(skin(), std::array{1.0}, {}).error,
            "the size of collision 'box::l::c' has 3 numbers, not 1");
  const Collision ground = simulation_->world().model("ground")->link("l")->collisions().front();
  EXPECT_EQ(properties().setSize(ground, std::array{1.0}, {}).error,
            "collision 'ground::l::c' has no size that can be changed: it is no box, sphere, cylinder, capsule or "
            "ellipsoid");
  Diagnostics diagnostics;
  EXPECT_EQ(simulation_->saveState(), before);
  const auto dumbbell = simulation_->insertText(kDumbbell, "dumbbell.sdf", {}, diagnostics);
  const std::vector<Collision> ends = dumbbell->link("l")->collisions();
  EXPECT_FALSE(properties().setSize(ends[0], std::array{0.2}, {.mass = true}));
  EXPECT_TRUE(properties().setSize(ends[0], std::array{0.2}, {}));
}

}  // namespace
}  // namespace pongsim
