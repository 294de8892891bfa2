#include <gtest/gtest.h>
#include <ignition/msgs/battery_state.pb.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/battery.hh"
#include "support/ask_service.hh"
#include "support/running_world.hh"

namespace pongsim::linearbatteryplugin_test {
namespace {

using test::RunningWorld;
using State = ignition::msgs::BatteryState;

constexpr const char* kCell =
    "<battery_name>cell</battery_name><voltage>12</voltage><capacity>0.01</capacity>"
    "<open_circuit_voltage_constant_coef>12</open_circuit_voltage_constant_coef>"
    "<open_circuit_voltage_linear_coef>-3</open_circuit_voltage_linear_coef><fix_issue_225>true</fix_issue_225>"
    "<smooth_current_tau>0.001</smooth_current_tau>";
constexpr const char* kLoad = "<power_load>40</power_load>";
constexpr const char* kDrains = "<start_draining>true</start_draining>";
constexpr const char* kRecharge = "<enable_recharge>true</enable_recharge><charging_time>0.01</charging_time>";

class LinearBatteryPluginTest : public testing::Test {
 protected:
  void start(const std::string& more) {
    world_.emplace(test::hingeWith("linearbatteryplugin", "LinearBatteryPlugin", std::string(kCell) + kLoad + more));
    world_->listen("/model/m/battery/cell/state", states_);
  }
  Joint hinge() { return world_->model("m").joint("hinge").value(); }
  Battery battery() { return Batteries(world_->simulation().world()).find(world_->model("m"), "cell").value(); }
  double charge() { return battery().charge(); }
  bool charges(bool starts) {
    ignition::msgs::Boolean request;
    ignition::msgs::Empty reply;
    return test::askService(world_->simulation().transport(),
                            std::string("/model/m/battery/cell/recharge/") + (starts ? "start" : "stop"), request,
                            reply)
               .outcome == CallOutcome::kDone;
  }

  std::optional<RunningWorld> world_;
  std::vector<State> states_;
};

TEST_F(LinearBatteryPluginTest, DrainsFromTheStartWhereItIsTold) {
  start(kDrains);
  EXPECT_EQ(charge(), 1);
  world_->step(1001);
  ASSERT_EQ(states_.size(), 51U);
  const State& state = states_.back();
  EXPECT_EQ(state.header().stamp().sec(), 1);
  // 40 W from 12 V take what is a tenth of 0.01 Ah in a second, some more as the voltage falls
  EXPECT_NEAR(state.percentage(), 90.6, 0.1);
  EXPECT_NEAR(state.charge(), 0.00906, 1e-5);
  EXPECT_EQ(state.capacity(), 0.01);
  EXPECT_NEAR(state.voltage(), 12 - 3 * 0.0937, 0.01);
  EXPECT_NEAR(state.current(), 40 / state.voltage(), 0.01);
  EXPECT_EQ(state.power_supply_status(), State::DISCHARGING);
}

TEST_F(LinearBatteryPluginTest, DrainsOnceAJointIsDriven) {
  start("");
  world_->step(500);
  EXPECT_EQ(charge(), 1);
  EXPECT_EQ(states_.back().power_supply_status(), State::FULL);
  hinge().addForce(0.1);
  world_->step(100);
  EXPECT_LT(charge(), 1);
}

TEST_F(LinearBatteryPluginTest, StartsAndStopsDrainingByMessagesOfAnyType) {
  start(
      "<power_draining_topic>/drain</power_draining_topic><power_draining_topic>on</power_draining_topic>"
      "<stop_power_draining_topic>/rest</stop_power_draining_topic>");
  world_->tellText("/drain", "ignition.msgs.LaserScan", "count: 1");
  world_->step(100);
  const double drained = charge();
  EXPECT_LT(drained, 1);
  world_->tell("/rest", ignition::msgs::Empty());
  world_->step(100);
  EXPECT_EQ(charge(), drained);
  world_->tell("/on", ignition::msgs::Boolean());
  world_->step(100);
  EXPECT_LT(charge(), drained);
}

TEST_F(LinearBatteryPluginTest, LetsTheJointsGoWhereItIsEmpty) {
  start("");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 11000; ++i) {
    hinge().setVelocityTarget(2);
    world_->step(1);
  }
  EXPECT_NE(testing::internal::GetCapturedStderr().find("the battery 'cell' is empty"), std::string::npos);
  EXPECT_LT(charge(), 0);
  hinge().setVelocityTarget(7);
  hinge().addForce(10);
  world_->step(100);
  EXPECT_NEAR(hinge().velocity(), 2, 1e-3);
}

TEST_F(LinearBatteryPluginTest, IsChargedByServices) {
  start(std::string(kRecharge) + "<initial_charge>0.005</initial_charge>");
  ASSERT_TRUE(charges(true));
  world_->step(3600);
  // a hundredth of an hour for all of it
  EXPECT_NEAR(charge(), 0.6, 1e-3);
  EXPECT_EQ(states_.back().power_supply_status(), State::CHARGING);
  EXPECT_NEAR(states_.back().current(), -1, 1e-3);
  ASSERT_TRUE(charges(false));
  world_->step(100);
  EXPECT_NEAR(charge(), 0.6, 1e-3);
  EXPECT_EQ(states_.back().power_supply_status(), State::NOT_CHARGING);
}

TEST_F(LinearBatteryPluginTest, IsChargedByTopicsWhereItIsTold) {
  start(std::string(kRecharge) + "<initial_charge>0.005</initial_charge><recharge_by_topic/>");
  world_->tell("/model/m/battery/cell/recharge/start", ignition::msgs::Boolean());
  world_->step(360);
  EXPECT_NEAR(charge(), 0.51, 1e-3);
  world_->tell("/model/m/battery/cell/recharge/stop", ignition::msgs::Boolean());
  world_->step(360);
  EXPECT_NEAR(charge(), 0.51, 1e-3);
}

TEST_F(LinearBatteryPluginTest, IsDrainedByOthersToo) {
  start(kDrains);
  battery().setLoad("lamp", 40);
  world_->step(1000);
  EXPECT_NEAR(charge(), 1 - 2 * 0.095, 5e-3);
}

TEST_F(LinearBatteryPluginTest, TurnsTheSignOfTheCurrentWhereItIsTold) {
  start(std::string(kDrains) + "<invert_current_sign>true</invert_current_sign>");
  world_->step(101);
  EXPECT_NEAR(states_.back().current(), -40 / states_.back().voltage(), 0.01);
}

TEST_F(LinearBatteryPluginTest, BeginsAgainAfterAReset) {
  start("");
  hinge().addForce(0.1);
  world_->step(100);
  EXPECT_LT(charge(), 1);
  Diagnostics diagnostics;
  world_->simulation().reset(diagnostics);
  EXPECT_EQ(charge(), 1);
  world_->step(100);
  EXPECT_EQ(charge(), 1);
  hinge().addForce(0.1);
  world_->step(100);
  EXPECT_LT(charge(), 1);
}

TEST_F(LinearBatteryPluginTest, GoesOnFromASavedState) {
  start(kDrains);
  world_->step(333);
  const std::vector<std::byte> state = world_->simulation().saveState();
  const double before = charge();
  world_->step(500);
  const double after = charge();
  EXPECT_TRUE(world_->simulation().restoreState(state));
  EXPECT_EQ(charge(), before);
  world_->step(500);
  EXPECT_EQ(charge(), after);
}

std::vector<std::string> complaintsAbout(const std::string& parameters) {
  return RunningWorld::complaintsAbout(test::hingeWith("linearbatteryplugin", "LinearBatteryPlugin", parameters));
}

TEST(LinearBatteryPlugin, SaysWhatIsWrong) {
  using Said = std::vector<std::string>;
  const std::string left = "linearbatteryplugin of m is left out: ";
  EXPECT_EQ(complaintsAbout(kLoad), (Said{left + "no <battery_name> is given", left + "no <voltage> is given",
                                          left + "no <capacity> is given"}));
  EXPECT_EQ(complaintsAbout(kCell), Said{"no <power_load> is given: the model draws no power from it"});
  EXPECT_EQ(complaintsAbout(std::string(kCell) + kLoad + "<enable_recharge>true</enable_recharge>"),
            Said{left + "no <charging_time> is given for a rechargeable battery"});
  EXPECT_EQ(complaintsAbout(std::string(kCell) + kLoad + "<initial_charge>2</initial_charge>"),
            Said{"<initial_charge> is not between 0 and the <capacity>: that is taken"});
  const std::string cell = std::string(kCell);
  const std::string slow = cell.substr(0, cell.find("<smooth")) + "<smooth_current_tau>0</smooth_current_tau>" + kLoad;
  EXPECT_EQ(complaintsAbout(slow), Said{"<smooth_current_tau> must be above 0: 1 is used"});
  EXPECT_EQ(complaintsAbout("<battery_name>b</battery_name><voltage>12</voltage><capacity>0</capacity>").size(), 1U);
}

}  // namespace
}  // namespace pongsim::linearbatteryplugin_test
