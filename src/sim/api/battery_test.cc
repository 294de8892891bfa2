#include "pongsim/battery.hh"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim {
namespace {

using test::RunningWorld;

/// Two models, "m" and "n", each with a wheel on a joint "j".
std::string twoWheels() {
  std::string models = "<gravity>0 0 0</gravity>";
  for (const char* name : {"m", "n"}) {
    models += std::string("<model name='") + name + R"('><link name="base"><inertial><mass>1</mass></inertial></link>
      <link name="wheel"><inertial><mass>1</mass></inertial></link>
      <joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
      <joint name="j" type="revolute"><parent>base</parent><child>wheel</child><axis><xyz>0 0 1</xyz></axis></joint>
      </model>)";
  }
  return models;
}

class BatteryTest : public testing::Test {
 protected:
  BatteryTest() : world_(twoWheels()), batteries_(world_.simulation().world()) {}
  Battery add(const char* model, const char* name, double charge) {
    return batteries_.add(world_.model(model), name, charge).value.value();
  }
  double velocity(const char* model) { return world_.model(model).joint("j")->velocity(); }

  RunningWorld world_;
  Batteries batteries_;
};

TEST_F(BatteryTest, IsFoundByItsModelAndName) {
  const Battery cell = add("m", "cell", 0.5);
  EXPECT_EQ(cell.name(), "cell");
  EXPECT_EQ(cell.model(), world_.model("m").id());
  EXPECT_EQ(cell.charge(), 0.5);
  EXPECT_EQ(batteries_.find(world_.model("m"), "cell")->id(), cell.id());
  EXPECT_FALSE(batteries_.find(world_.model("n"), "cell"));
  EXPECT_EQ(batteries_.add(world_.model("m"), "cell", 1).error, "model 'm' has a battery 'cell' already");
  add("n", "cell", 1);
  EXPECT_EQ(batteries_.named("cell").size(), 2U);
  EXPECT_TRUE(batteries_.named("cellar").empty());
}

TEST_F(BatteryTest, AddsUpWhatIsTakenFromIt) {
  Battery cell = add("m", "cell", 1);
  EXPECT_EQ(cell.load(), 0);
  cell.setLoad("lamp", 2);
  cell.setLoad("radio", 3);
  cell.setLoad("lamp", 1);
  EXPECT_EQ(cell.load(), 4);
  testing::internal::CaptureStderr();
  cell.setLoad("lamp", std::numeric_limits<double>::infinity());
  EXPECT_NE(testing::internal::GetCapturedStderr().find("battery 'cell' was given a load that is not finite"),
            std::string::npos);
  EXPECT_EQ(cell.load(), 4);
}

TEST_F(BatteryTest, LetsTheJointsOfItsModelGoFreelyWhereItIsEmpty) {
  Battery cell = add("m", "cell", 0.1);
  for (const char* model : {"m", "n"}) world_.model(model).joint("j")->setVelocityTarget(2);
  world_.step(10);
  EXPECT_NEAR(velocity("m"), 2, 1e-6);
  cell.setCharge(0);
  EXPECT_TRUE(batteries_.areEmpty(world_.model("m")));
  EXPECT_FALSE(batteries_.areEmpty(world_.model("n")));
  for (int i = 0; i < 10; ++i) {
    for (const char* model : {"m", "n"}) world_.model(model).joint("j")->setVelocityTarget(5);
    world_.step(1);
  }
  EXPECT_NEAR(velocity("m"), 2, 1e-6);
  EXPECT_NEAR(velocity("n"), 5, 1e-6);
  world_.model("m").joint("j")->addForce(10);
  world_.step(1);
  EXPECT_NEAR(velocity("m"), 2, 1e-6);
  cell.setCharge(0.1);
  world_.model("m").joint("j")->addForce(10);
  world_.step(1);
  EXPECT_GT(velocity("m"), 2.005);
}

TEST_F(BatteryTest, IsNotAloneWhereAnotherOneIsFull) {
  add("m", "cell", 0);
  add("m", "reserve", 0.5);
  EXPECT_FALSE(batteries_.areEmpty(world_.model("m")));
}

TEST_F(BatteryTest, GoesWithItsModelAndStaysThroughAReset) {
  const Battery cell = add("m", "cell", 1), other = add("n", "cell", 1);
  EXPECT_TRUE(world_.simulation().remove(world_.model("m")));
  EXPECT_FALSE(cell.exists());
  EXPECT_THROW(static_cast<void>(cell.charge()), Gone);
  Diagnostics diagnostics;
  world_.simulation().reset(diagnostics);
  EXPECT_FALSE(cell.exists());
  EXPECT_TRUE(other.exists());
}

}  // namespace
}  // namespace pongsim
