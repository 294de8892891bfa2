#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/imu.pb.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/example_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::faults_test {
namespace {

using ignition::msgs::IMU;
using test::RunningWorld;

constexpr const char* kRover = "plugins/drives/diff-drive/diff_drive.sdf";
constexpr const char* kExample = "plugins/tasks/faults/faults.sdf";

std::string faults(const std::string& content) {
  return "<plugin filename='pongsim-faults-system' name='pongsim::systems::Faults'>" + content + "</plugin>";
}

/// A link that turns, and an IMU that measures it in each step.
const std::string kImu =
    "<plugin filename='ignition-gazebo-imu-system' name='ignition::gazebo::systems::Imu'/><model name='top'><link "
    "name='l'><sensor name='s' type='imu'><topic>imu</topic><update_rate>1000</update_rate></sensor></link></model>";

/// The steps in which messages arrived and those of their stamps.
struct Arrivals {
  std::vector<std::pair<int, int>> all;

  void run(RunningWorld& world, int steps) {
    int now = 0;
    const Subscription imu = world.simulation().transport().node().subscribe<IMU>("/imu", [&](const IMU& message) {
      const auto& stamp = message.header().stamp();
      all.emplace_back(now, static_cast<int>(stamp.sec() * 1000 + stamp.nsec() / 1000000));
    });
    for (now = 1; now <= steps; ++now) world.step(1);
  }
};

TEST(Faults, DelayToTheStep) {
  RunningWorld world(kImu + faults("<fault type='delay' topic='/imu' delay='0.05' from='0.1' to='0.2'/>"));
  Arrivals arrivals;
  arrivals.run(world, 300);
  ASSERT_EQ(arrivals.all.size(), 300U);
  for (const auto& [now, stamp] : arrivals.all) {
    EXPECT_EQ(now - stamp, stamp >= 100 && stamp < 200 ? 50 : 0) << stamp;
  }
}

int countOf(const std::string& fault, std::uint64_t seed, bool hasOther = false) {
  Diagnostics diagnostics;
  const auto world =
      Simulation::fromText(RunningWorld::textOf(kImu + faults(fault)), "world.sdf", {.seed = seed}, diagnostics);
  int count = 0, others = 0;
  const Subscription imu = world->transport().node().subscribe<IMU>("/imu", [&](const IMU&) { ++count; });
  Subscription other;
  if (hasOther) other = world->transport().node().subscribe<IMU>("/imu", [&](const IMU&) { ++others; });
  world->step(2000);
  world->transport().dispatch();
  EXPECT_EQ(others, hasOther ? count : 0);
  return count;
}

TEST(Faults, DropAndDuplicateAtTheirRatesAndRepeatWithTheSeed) {
  // four standard deviations of a binomial distribution
  const double spread = 4 * std::sqrt(2000 * 0.3 * 0.7);
  const std::string drop = "<fault type='drop' topic='/imu' probability='0.3'/>";
  const int left = countOf(drop, 1);
  EXPECT_NEAR(left, 1400, spread);
  EXPECT_EQ(countOf(drop, 1, true), left);
  EXPECT_NE(countOf(drop, 2), left);
  const std::string twice = "<fault type='duplicate' topic='/imu' probability='0.3'/>";
  EXPECT_NEAR(countOf(twice, 1), 2600, spread);
  EXPECT_EQ(countOf("<fault type='drop' topic='/imu' from='0.5' to='0.6' every='1'/>", 1), 1800);
  // one after the other, in their order
  EXPECT_EQ(countOf("<fault type='duplicate' topic='/imu'/><fault type='duplicate' topic='/imu' to='1'/>", 1),
            4 * 999 + 2 * 1001);
}

TEST(Faults, FreezeATopic) {
  RunningWorld world(kImu + faults("<fault type='freeze' topic='/imu' from='0.1' to='0.2'/>"));
  Arrivals arrivals;
  arrivals.run(world, 300);
  ASSERT_EQ(arrivals.all.size(), 300U);
  for (const auto& [now, stamp] : arrivals.all) EXPECT_EQ(stamp, now >= 100 && now < 200 ? 99 : now);
}

TEST(Faults, AddNoise) {
  RunningWorld world(kImu +
                     faults("<fault type='noise' topic='/imu' stddev='0.5' field='angular_velocity' to='0.1'/>"));
  std::vector<IMU> heard;
  world.listen("/imu", heard);
  world.step(200);
  ASSERT_EQ(heard.size(), 200U);
  double squares = 0;
  for (int i = 0; i < 99; ++i) {
    squares += std::pow(heard[static_cast<std::size_t>(i)].angular_velocity().x(), 2);
    EXPECT_EQ(heard[static_cast<std::size_t>(i)].linear_acceleration().x(), 0);
  }
  EXPECT_NEAR(std::sqrt(squares / 99), 0.5, 0.15);
  EXPECT_EQ(heard.back().angular_velocity().x(), 0);
}

TEST(Faults, SilenceASensorThatComesBack) {
  RunningWorld world(kImu + faults("<fault type='sensor' sensor='top::l::s' from='0.1' to='0.2'/>"));
  Arrivals arrivals;
  arrivals.run(world, 300);
  ASSERT_EQ(arrivals.all.size(), 200U);
  EXPECT_EQ(arrivals.all[98].second, 99);
  EXPECT_EQ(arrivals.all[99].second, 200);
}

/// A hinge that is driven, with an effort limit in its place.
std::string hinge(const std::string& fault, const std::string& limit = "") {
  const std::string text = test::hingeWith("joint-controller", "JointController", "<joint_name>hinge</joint_name>");
  return faults(fault) + (limit.empty() ? text : test::replaced(text, "<xyz>0 0 1</xyz>", "<xyz>0 0 1</xyz>" + limit));
}

constexpr const char* kDrive = "/model/m/joint/hinge/cmd_vel";

TEST(Faults, DelayCommandsThatComeFromOutside) {
  RunningWorld world(hinge(std::string("<fault type='delay' topic='") + kDrive + "' delay='0.05'/>"));
  Transport outside(world.simulation().transport(), Transport::Sharing());
  Publisher command = outside.node().advertise<ignition::msgs::Double>(kDrive);
  const Joint joint = world.model("m").joint("hinge").value();
  world.simulation().step(10);
  ignition::msgs::Double speed;
  speed.set_data(2);
  command.publish(speed);
  world.simulation().step(50);
  EXPECT_EQ(joint.velocity(), 0);
  world.simulation().step(1);
  EXPECT_NEAR(joint.velocity(), 2, 1e-3);
}

TEST(Faults, LetAJointStickAgainstItsMotor) {
  RunningWorld world(hinge("<fault type='stick' joint='m::hinge' from='0.5' to='1'/>"));
  const Joint joint = world.model("m").joint("hinge").value();
  world.tellNumber(kDrive, 2);
  world.step(500);
  const double stuck = joint.position();
  EXPECT_NEAR(stuck, 1, 0.01);
  for (int i = 0; i < 500; ++i) {
    world.step(1);
    ASSERT_NEAR(joint.position(), stuck, 1e-4) << i;
  }
  world.step(500);
  EXPECT_NEAR(joint.position(), stuck + 1, 0.01);
}

TEST(Faults, WeakenAMotor) {
  // 0.1 kg m^2, without and with a limit in the file
  for (const char* limit : {"", "<limit><effort>0.04</effort></limit>"}) {
    const std::string what = *limit == 0 ? "effort='0.02'" : "factor='0.5'";
    RunningWorld world(hinge("<fault type='weaken' joint='m::hinge' " + what + " to='1'/>", limit));
    const Joint joint = world.model("m").joint("hinge").value();
    world.tellNumber(kDrive, 2);
    world.step(1000);
    EXPECT_NEAR(joint.velocity(), 0.2, 0.001) << what;
    world.step(10'000);
    EXPECT_NEAR(joint.velocity(), 2, 0.001) << what;
  }
}

double driven(const std::string& fault) {
  RunningWorld world(test::modelsOf(kRover) + faults(fault));
  world.tellText("/model/rover/cmd_vel", "ignition.msgs.Twist", "linear {x: 1}");
  world.step(1000);
  return world.model("rover").pose().position.x();
}

TEST(Faults, LetWheelsSlip) {
  const double firm = driven("<fault type='drop' topic='/nobody' to='0.001'/>");
  EXPECT_GT(firm, 0.5);
  const std::string wheels =
      "<fault type='slip' joint='rover::left_wheel_joint' friction='#'/><fault type='slip' "
      "joint='rover::right_wheel_joint' friction='#'/>";
  const auto with = [&wheels](const std::string& friction) {
    return driven(test::replaced(test::replaced(wheels, "#", friction), "#", friction));
  };
  EXPECT_LT(with("0.02"), 0.5 * firm);
  EXPECT_NEAR(with("1"), firm, 1e-12);
}

const std::string kSeveral =
    "<fault type='delay' topic='/imu' delay='0.05' probability='0.5'/><fault type='drop' topic='/imu' "
    "probability='0.2'/><fault type='freeze' topic='/imu' from='0.12' to='0.3'/><fault type='stick' joint='m::hinge' "
    "from='0.1' to='0.2'/><fault type='weaken' joint='m::hinge' effort='1' from='0.05' to='0.3'/>";

TEST(Faults, GoOnFromASavedState) {
  RunningWorld world(kImu + hinge(kSeveral)), other(kImu + hinge(kSeveral));
  std::vector<IMU> heard;
  world.listen("/imu", heard);
  world.tellNumber(kDrive, 2);
  world.step(150);
  test::expectSameBitsFromSavedState<IMU>(world, other, 200, "/imu");
}

TEST(Faults, BeginAnewAfterAReset) {
  RunningWorld world(kImu + hinge(kSeveral));
  std::vector<IMU> heard;
  world.listen("/imu", heard);
  const auto run = [&] {
    heard.clear();
    world.tellNumber(kDrive, 2);
    world.step(170);
    std::string all;
    for (const IMU& message : heard) all += message.SerializeAsString();
    return all + std::to_string(world.simulation().stateHash());
  };
  const std::string first = run();
  test::resetWorld(world);
  EXPECT_EQ(run(), first);
}

TEST(Faults, EndTheRunWhereTheyAreWrong) {
  const auto errorOf = [](const std::string& content) {
    Diagnostics diagnostics;
    EXPECT_EQ(Simulation::fromText(RunningWorld::textOf(content), "world.sdf", {}, diagnostics), nullptr);
    return diagnostics.all().empty() ? "" : diagnostics.all().front().message + "; " + diagnostics.all().front().hint;
  };
  EXPECT_EQ(errorOf(hinge("<fault type='stick' joint='m::hing'/>")),
            "there is no joint 'm::hing'; did you mean 'm::hinge'?");
  EXPECT_EQ(errorOf(hinge("<fault type='weaken' joint='m::hinge' factor='0.5'/>")),
            "the effort of joint 'm::hinge' has no limit, of which there could be a part; write effort=\"E\" with what "
            "is left of it [N m or N]");
  EXPECT_EQ(errorOf(hinge("<fault type='stick' joint='m::hold'/>")), "joint 'm::hold' has no axis; ");
  EXPECT_EQ(errorOf(hinge("<fault type='slip' joint='m::hinge'/>")),
            "the child of joint 'm::hinge' has no collision that could slip; ");
  EXPECT_EQ(errorOf(kImu + faults("<fault type='sensor' sensor='top::l::z'/>")),
            "there is no sensor 'top::l::z'; did you mean 'top::l::s'?");
  EXPECT_EQ(errorOf(faults("<fault type='drp' topic='/a'/>")), "there is no fault 'drp'; did you mean 'drop'?");
  EXPECT_EQ(errorOf(faults("<fault type='drop' topic='/a'/>") + faults("<fault type='drop' topic='/a'/>")),
            "topic '/a' is already intercepted; ");
}

TEST(Faults, AreInTheExampleAsItSays) {
  RunningWorld world(test::projectFolder() / kExample);
  std::vector<IMU> heard;
  world.listen("/imu", heard);
  world.tellText("/model/rover/cmd_vel", "ignition.msgs.Twist", "linear {x: 0.5}");
  world.step(2000);
  const auto yaw = [&] { return std::abs(yawOf(world.model("rover").pose().rotation)); };
  EXPECT_LT(yaw(), 0.001);
  EXPECT_NEAR(static_cast<double>(heard.size()), 134, 4 * std::sqrt(200 * 0.33 * 0.67));
  world.tellText("/model/rover/cmd_vel", "ignition.msgs.Twist", "linear {x: 1}");
  world.step(2000);
  EXPECT_GT(yaw(), 0.01);
}

TEST(Faults, WarnOfATopicThatNobodyUses) {
  RunningWorld world(kImu + faults("<fault type='drop' topic='/imo'/>"));
  testing::internal::CaptureStderr();
  world.step(2);
  EXPECT_NE(testing::internal::GetCapturedStderr().find(
                "nobody in the world uses the topic '/imo', which has a fault: did you mean '/imu'?"),
            std::string::npos);
}

}  // namespace
}  // namespace pongsim::faults_test
