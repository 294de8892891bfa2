// Changes of a world between steps, by the handles and by `Simulation`.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/sensing/sensor.hh"
#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

constexpr const char* kChangedWorld = R"(<sdf version="1.9"><world name="w">
  <model name="ground"><static>true</static><link name="link">
    <collision name="c"><geometry><plane/></geometry></collision></link></model>
  <model name="table"><static>true</static><pose>5 0 0 0 0 0</pose><link name="link"><pose>0 0 0.5 0 0 0</pose>
    <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>
  <model name="ball"><pose>0 0 1 0 0 0</pose><link name="skin"><inertial><mass>1</mass></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link></model>
  <model name="arm"><pose>0 5 1 0 0 0</pose>
    <link name="upper"><inertial><mass>2</mass></inertial></link>
    <link name="lower"><pose>1 0 0 0 0 0</pose><inertial><mass>2</mass></inertial>
      <sensor name="imu" type="imu"/></link>
    <joint name="elbow" type="revolute"><parent>upper</parent><child>lower</child><axis><xyz>0 0 1</xyz></axis></joint>
  </model>
  <model name="post"><pose>0 10 0 0 0 0</pose><link name="pole"/>
    <joint name="root" type="fixed"><parent>world</parent><child>pole</child></joint></model>
  <light name="sun" type="directional"/></world></sdf>)";

constexpr const char* kBoxModel = R"(<sdf version="1.9"><model name="box"><pose>2 0 3 0 0 0</pose>
  <link name="body"><inertial><mass>1</mass></inertial>
    <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model></sdf>)";

class ChangedWorld : public testing::Test {
 protected:
  ChangedWorld() : simulation_(make()) {}

  static std::unique_ptr<Simulation> make() {
    Diagnostics diagnostics;
    auto simulation = Simulation::fromText(kChangedWorld, "world.sdf", {.loadSystems = false}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    return simulation;
  }
  World world() { return simulation_->world(); }
  Model model(std::string_view name) { return world().model(name).value(); }
  std::optional<Model> insert(const char* text, const InsertOptions& options = {}) {
    Diagnostics diagnostics;
    auto model = simulation_->insertText(text, "box.sdf", options, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    return model;
  }
  std::string refusal(const char* text, const InsertOptions& options = {}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(simulation_->insertText(text, "box.sdf", options, diagnostics));
    return diagnostics.all().empty() ? "" : format(diagnostics.all().front());
  }
  void reset() {
    Diagnostics diagnostics;
    simulation_->reset(diagnostics);
    EXPECT_TRUE(diagnostics.all().empty());
  }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(ChangedWorld, TakesAModelInThatFallsAndTouches) {
  simulation_->step(100);
  const std::optional<Model> box = insert(kBoxModel);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->pose().position, Vector3(2, 0, 3));
  simulation_->step(2000);
  EXPECT_NEAR(box->pose().position.z(), 0.5, 1e-3);
  std::vector<Contact> contacts;
  world().contacts(contacts);
  bool touches = false;
  for (const Contact& contact : contacts) {
    touches = touches || world().collision(contact.collision2)->scopedName() == "box::body::c";
  }
  EXPECT_TRUE(touches);
}

TEST_F(ChangedWorld, TakesNameAndPoseFromTheCaller) {
  const auto box = insert(kBoxModel, {.name = "crate", .pose = Pose{{7, 0, 1}, Quaternion(2, 0, 0, 0)}});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->name(), "crate");
  EXPECT_EQ(box->pose().position, Vector3(7, 0, 1));
  EXPECT_EQ(box->pose().rotation.w(), 1);
}

TEST_F(ChangedWorld, RefusesANameThatIsTakenOrRenames) {
  ASSERT_TRUE(insert(kBoxModel));
  EXPECT_NE(refusal(kBoxModel).find("there is a 'box' in the world already"), std::string::npos);
  EXPECT_NE(refusal(kBoxModel, {.name = "sun"}).find("there is a 'sun'"), std::string::npos);
  EXPECT_EQ(insert(kBoxModel, {.allowRenaming = true})->name(), "box_0");
  EXPECT_EQ(insert(kBoxModel, {.allowRenaming = true})->name(), "box_1");
}

TEST_F(ChangedWorld, RefusesWhatIsNoModel) {
  const std::uint64_t before = simulation_->stateHash();
  EXPECT_NE(refusal("<sdf version='1.9'><model name='m'/></sdf>").find("model 'm'"), std::string::npos);
  EXPECT_NE(refusal("<sdf version='1.9'><world name='m'/></sdf>").find("no model to insert"), std::string::npos);
  EXPECT_NE(refusal(kBoxModel, {.name = "a::b"}).find("'::'"), std::string::npos);
  const Pose nowhere{{std::numeric_limits<double>::quiet_NaN(), 0, 0}, Quaternion::Identity()};
  EXPECT_NE(refusal(kBoxModel, {.pose = nowhere}).find("not finite"), std::string::npos);
  EXPECT_EQ(simulation_->stateHash(), before);
  EXPECT_FALSE(world().model("box"));
}

TEST_F(ChangedWorld, LetsAModelGoAndItsHandlesSaySo) {
  simulation_->step(1000);
  Model arm = model("arm");
  const Link lower = arm.link("lower").value();
  const Joint elbow = arm.joint("elbow").value();
  const Sensor imu = lower.sensors().at(0);
  const Collision skin = model("ball").link("skin")->collisions().at(0);
  EXPECT_TRUE(simulation_->remove(arm));
  EXPECT_FALSE(arm.exists() || lower.exists() || elbow.exists() || imu.exists());
  EXPECT_THROW(arm.pose(), Gone);
  EXPECT_THROW(lower.pose(), Gone);
  EXPECT_THROW(elbow.position(), Gone);
  EXPECT_THROW(imu.pose(), Gone);
  EXPECT_EQ(simulation_->remove(arm).error, "the model no longer exists");
  EXPECT_TRUE(skin.exists());
  EXPECT_EQ(skin.scopedName(), "ball::skin::c");
  simulation_->step(1000);
  EXPECT_NEAR(model("ball").pose().position.z(), 0.5, 1e-3);
}

TEST_F(ChangedWorld, LetsWhatLaysOnAModelFallWhenThatGoes) {
  model("ball").setPose({{5, 0, 1.5}, Quaternion::Identity()}, AfterMove::kStop);
  simulation_->step(1000);
  ASSERT_NEAR(model("ball").pose().position.z(), 1.5, 1e-3);
  EXPECT_TRUE(simulation_->remove(model("table")));
  simulation_->step(1000);
  EXPECT_NEAR(model("ball").pose().position.z(), 0.5, 1e-3);
}

TEST_F(ChangedWorld, MovesAWholeModelAtOnce) {
  Model arm = model("arm");
  arm.setVelocity({1, 0, 0}, Vector3::Zero());
  const Quaternion turn = fromRollPitchYaw(0, 0, M_PI / 2);
  EXPECT_TRUE(arm.setPose({{3, 3, 3}, turn}));
  EXPECT_TRUE(arm.link("lower")->pose().position.isApprox(Vector3(3, 4, 3)));
  EXPECT_TRUE(arm.link("lower")->linearVelocity().isApprox(Vector3(0, 1, 0)));
  simulation_->step();
  EXPECT_NEAR(arm.link("lower")->pose().position.y(), 4.001, 1e-6);
  EXPECT_NEAR(arm.joint("elbow")->position(), 0, 1e-9);
  EXPECT_TRUE(arm.setPose({{0, 0, 9}, turn}, AfterMove::kStop));
  EXPECT_EQ(arm.link("lower")->linearVelocity(), Vector3::Zero());
}

TEST_F(ChangedWorld, MovesWhatIsStatic) {
  EXPECT_TRUE(model("table").setPose({{0, 0, -0.5}, Quaternion::Identity()}));
  EXPECT_EQ(model("table").link("link")->pose().position, Vector3(0, 0, 0));
  simulation_->step(1500);
  EXPECT_NEAR(model("ball").pose().position.z(), 1, 1e-3);
}

TEST_F(ChangedWorld, MovesALinkThatNoJointHolds) {
  EXPECT_TRUE(model("ball").link("skin")->setPose({{0, 0, 8}, Quaternion::Identity()}));
  EXPECT_EQ(model("ball").pose().position.z(), 8);
  EXPECT_EQ(model("arm").link("upper")->setPose(Pose()).error, "link 'upper' is held by joint 'elbow'");
  EXPECT_EQ(model("post").setPose(Pose()).error, "model 'post' is held by joint 'root'");
  const Pose nowhere{{0, 0, 0}, Quaternion(0, 0, 0, 0)};
  EXPECT_EQ(model("ball").setPose(nowhere).error, "the pose is not finite");
  for (const double far : {1.1e9, -1e300}) {
    const Pose away{{0, far, 0}, Quaternion::Identity()};
    EXPECT_EQ(model("ball").setPose(away).error, "the pose is not within 1e9 m of the origin");
  }
}

TEST_F(ChangedWorld, HoldsTwoLinksTogetherUntilTheyAreDetached) {
  const Link ball = model("ball").link("skin").value();
  Outcome<Joint> joint = world().attach(model("post").link("pole").value(), ball, "rope");
  ASSERT_TRUE(joint) << joint.error;
  EXPECT_EQ(joint->name(), "rope");
  EXPECT_EQ(joint->type(), "fixed");
  simulation_->step(500);
  EXPECT_NEAR(ball.pose().position.z(), 1, 1e-3);
  EXPECT_TRUE(world().detach(*joint));
  EXPECT_FALSE(joint->exists());
  EXPECT_EQ(world().detach(*joint).error, "the joint no longer exists");
  simulation_->step(500);
  EXPECT_NEAR(ball.pose().position.z(), 0.5, 1e-3);
  EXPECT_EQ(world().attach(ball, ball).error, "a link can't be attached to itself");
}

TEST_F(ChangedWorld, LetsAttachedLinksTouchAgainOnceDetached) {
  const auto box = insert(kBoxModel, {.pose = Pose{{0, 0, 2}, Quaternion::Identity()}});
  simulation_->step(1000);
  Link body = box->link("body").value();
  ASSERT_NEAR(body.pose().position.z(), 1.5, 2e-3);
  Outcome<Joint> joint = world().attach(model("ball").link("skin").value(), body);
  ASSERT_TRUE(joint);
  const auto touches = [&] {
    std::vector<Contact> contacts;
    world().contacts(contacts);
    const CollisionId id = body.collisions()[0].id();
    return std::ranges::any_of(contacts, [&](const Contact& c) { return c.collision1 == id || c.collision2 == id; });
  };
  simulation_->step(10);
  EXPECT_FALSE(touches());
  EXPECT_TRUE(world().detach(*joint));
  simulation_->step(10);
  EXPECT_TRUE(touches());
  EXPECT_NEAR(body.pose().position.z(), 1.5, 2e-3);
}

TEST_F(ChangedWorld, LosesAnAttachmentWithItsModel) {
  Outcome<Joint> joint = world().attach(model("ball").link("skin").value(), model("arm").link("upper").value());
  ASSERT_TRUE(joint);
  EXPECT_TRUE(simulation_->remove(model("ball")));
  EXPECT_FALSE(joint->exists());
  simulation_->step(10);
}

TEST_F(ChangedWorld, FallsAsGravitySays) {
  EXPECT_TRUE(world().setGravity({0, 0, 2}));
  EXPECT_EQ(world().gravity(), Vector3(0, 0, 2));
  simulation_->step(100);
  EXPECT_NEAR(model("ball").link("skin")->linearVelocity().z(), 0.2, 1e-9);
  EXPECT_EQ(world().setGravity({0, 0, std::numeric_limits<double>::infinity()}).error, "gravity is not finite");
  EXPECT_EQ(world().setGravity({0, 0, 1e308}).error, "gravity is beyond 1e6 m/s^2");
  // gravity also applies to models that are inserted later
  EXPECT_TRUE(insert(kBoxModel));
  simulation_->step();
  EXPECT_NEAR(model("box").link("body")->linearVelocity().z(), 0.002, 1e-9);
}

TEST_F(ChangedWorld, StepsAsItIsTold) {
  EXPECT_TRUE(simulation_->setStepSize(std::chrono::milliseconds(5)));
  simulation_->step(2);
  EXPECT_EQ(simulation_->time(), std::chrono::milliseconds(10));
  EXPECT_FALSE(simulation_->setStepSize(Time(0)));
  EXPECT_FALSE(simulation_->setStepSize(Time(-1)));
  EXPECT_FALSE(simulation_->setStepSize(std::chrono::milliseconds(1001)));
  EXPECT_TRUE(simulation_->setRealTimeFactor(0.5));
  EXPECT_EQ(simulation_->realTimeFactor(), 0.5);
  EXPECT_FALSE(simulation_->setRealTimeFactor(-1));
  EXPECT_EQ(simulation_->realTimeFactor(), 0.5);
}

TEST_F(ChangedWorld, GoesBackToTheFirstBit) {
  const std::uint64_t start = simulation_->stateHash();
  simulation_->step(777);
  const std::uint64_t later = simulation_->stateHash();
  const Model ball = model("ball");
  const Link lower = model("arm").link("lower").value();

  insert(kBoxModel);
  const Model box = model("box");
  EXPECT_TRUE(simulation_->remove(ball));
  world().setGravity({1, 0, 0});
  simulation_->setStepSize(std::chrono::milliseconds(3));
  EXPECT_TRUE(world().attach(lower, model("post").link("pole").value()));
  simulation_->step(100);

  reset();
  EXPECT_EQ(simulation_->time(), Time(0));
  EXPECT_EQ(simulation_->iterations(), 0U);
  EXPECT_EQ(simulation_->stateHash(), start);
  EXPECT_EQ(simulation_->stepSize(), std::chrono::milliseconds(1));
  EXPECT_FALSE(box.exists());
  EXPECT_TRUE(ball.exists());
  EXPECT_EQ(ball.name(), "ball");
  simulation_->step(777);
  EXPECT_EQ(simulation_->stateHash(), later);
}

TEST_F(ChangedWorld, ChangesAlikeInEachRun) {
  const auto run = [] {
    auto simulation = make();
    Diagnostics diagnostics;
    for (int i = 0; i < 5; ++i) {
      simulation->step(100);
      const Pose pose{{0.1 * i, 0, 3.0 + i}, Quaternion::Identity()};
      simulation->insertText(kBoxModel, "box.sdf", {.pose = pose, .allowRenaming = true}, diagnostics);
    }
    simulation->step(300);
    simulation->remove(*simulation->world().model("box_0"));
    simulation->remove(*simulation->world().model("table"));
    simulation->step(500);
    return simulation->stateHash();
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace pongsim
