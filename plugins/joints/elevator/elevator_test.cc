#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/laserscan.pb.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::elevator_test {
namespace {

using test::RunningWorld;

std::string exampleWorld() {
  std::ifstream file(test::projectFolder() / "plugins/joints/elevator/elevator.sdf");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  if (position != std::string::npos) text.replace(position, from.size(), to);
  return text;
}

class ElevatorTest : public testing::Test {
 protected:
  void start(const std::filesystem::path& file) {
    world_.emplace(file);
    world_->listen("/model/elevator/state", messages_);
  }
  void start() { start(test::projectFolder() / "plugins/joints/elevator/elevator.sdf"); }
  void call(int floor) {
    ignition::msgs::Int32 message;
    message.set_data(floor);
    world_->tell("/model/elevator/cmd", message);
  }
  void block(int floor, bool isBlocked) {
    ignition::msgs::LaserScan scan;
    scan.set_range_max(1.4);
    scan.add_ranges(isBlocked ? 0.7 : 1.4);
    world_->tell("/model/elevator/door_" + std::to_string(floor) + "/lidar", scan);
  }
  double at(const char* joint) { return world_->model("elevator").joint(joint)->position(); }
  /// @return The states, each once.
  std::vector<int> states() {
    std::vector<int> numbers;
    for (const auto& message : messages_) {
      if (numbers.empty() || numbers.back() != message.data()) numbers.push_back(message.data());
    }
    return numbers;
  }

  std::optional<RunningWorld> world_;
  std::vector<ignition::msgs::Int32> messages_;
};

TEST_F(ElevatorTest, StandsAndSaysWhereFiveTimesASecond) {
  start();
  world_->step(2001);
  EXPECT_EQ(messages_.size(), 10U);
  EXPECT_EQ(states(), std::vector<int>{0});
}

TEST_F(ElevatorTest, GoesUpOpensAndClosesItsDoorAndComesBack) {
  start();
  call(2);
  world_->step(10000);
  EXPECT_NEAR(at("lift"), 6, 0.1);
  EXPECT_NEAR(at("door_2"), 1, 0.05);
  EXPECT_NEAR(at("door_0"), 0, 0.02);
  world_->step(10000);
  EXPECT_NEAR(at("door_2"), 0, 0.05);
  EXPECT_EQ(states(), (std::vector<int>{0, 1, 2}));
  call(1);
  world_->step(9000);
  EXPECT_NEAR(at("lift"), 3, 0.1);
  EXPECT_NEAR(at("door_1"), 1, 0.05);
  EXPECT_EQ(states(), (std::vector<int>{0, 1, 2, 1}));
}

TEST_F(ElevatorTest, KeepsABlockedDoorOpen) {
  start();
  call(0);
  block(0, true);
  world_->step(15000);
  EXPECT_NEAR(at("door_0"), 1, 0.05);
  block(0, false);
  world_->step(15000);
  EXPECT_NEAR(at("door_0"), 0, 0.05);
}

TEST_F(ElevatorTest, IgnoresFloorsThatItHasNot) {
  start();
  testing::internal::CaptureStderr();
  call(3);
  call(-1);
  world_->step(2000);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("there is no floor 3, only 0 to 2: the call was ignored"), std::string::npos) << said;
  EXPECT_NE(said.find("there is no floor -1"), std::string::npos) << said;
  EXPECT_NEAR(at("lift"), 0, 0.05);
}

TEST_F(ElevatorTest, BeginsAgainAfterAResetAndGoesOnFromASavedState) {
  start();
  call(1);
  world_->step(1500);
  const std::vector<std::byte> state = world_->simulation().saveState();
  world_->step(4000);
  EXPECT_GT(at("door_1"), 0.5);
  const std::uint64_t hash = world_->simulation().stateHash();
  Diagnostics diagnostics;
  world_->simulation().reset(diagnostics);
  world_->step(3000);
  EXPECT_NEAR(at("lift"), 0, 0.05);
  EXPECT_TRUE(world_->simulation().restoreState(state));
  world_->step(4000);
  EXPECT_EQ(world_->simulation().stateHash(), hash);
}

std::vector<std::string> complaintsAbout(const std::string& world) {
  Diagnostics diagnostics;
  EXPECT_NE(Simulation::fromText(world, "world.sdf", {}, diagnostics), nullptr);
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    EXPECT_GT(diagnostic.position.line, 0);
    messages.push_back(diagnostic.message);
  }
  return messages;
}

TEST(Elevator, SaysWhatIsMissing) {
  const std::string left = "elevator of elevator is left out: ";
  const auto with = [](const std::string& parameters) {
    return replaced(exampleWorld(), "systems::Elevator\"/>", "systems::Elevator\">" + parameters + "</plugin>");
  };
  EXPECT_EQ(complaintsAbout(with("<cabin_joint>hoist</cabin_joint>")),
            std::vector<std::string>{left + "there is no joint 'hoist' for the cabin"});
  EXPECT_EQ(complaintsAbout(with("<cabin_joint>foundation</cabin_joint>")),
            std::vector<std::string>{left + "joint 'foundation' of the cabin has no axis to drive"});
  EXPECT_EQ(complaintsAbout(with("<floor_link_prefix>storey_</floor_link_prefix>")),
            std::vector<std::string>{left + "model 'elevator' has no floors"});
  EXPECT_EQ(complaintsAbout(with("<door_joint_prefix>gate_</door_joint_prefix>")),
            std::vector<std::string>{left + "there is no joint 'gate_0' for the door of floor 0"});
  std::string gap = exampleWorld();
  for (int i = 0; i < 2; ++i)
    gap = replaced(gap, i == 0 ? "<link name=\"floor_1\"" : "<child>floor_1<",
                   i == 0 ? "<link name=\"floor_7\"" : "<child>floor_7<");
  EXPECT_EQ(complaintsAbout(gap), std::vector<std::string>{left + "there is no link 'floor_1' for floor 1 of 3"});
  EXPECT_EQ(complaintsAbout(replaced(exampleWorld(), "<upper>1</upper>", "")),
            std::vector<std::string>{left + "joint 'door_0' has no upper limit: that is where the door is open"});
}

// As Fortress's own test has it.
TEST_F(ElevatorTest, OfFortressTestWorldGoesUpAndDown) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  start(*worlds / "test/elevator.sdf");
  world_->step(200);
  EXPECT_EQ(states(), std::vector<int>{0});
  call(2);
  world_->step(25000);
  EXPECT_EQ(states(), (std::vector<int>{0, 1, 2}));
  call(1);
  world_->step(25000);
  EXPECT_EQ(states(), (std::vector<int>{0, 1, 2, 1}));
}

}  // namespace
}  // namespace pongsim::elevator_test
