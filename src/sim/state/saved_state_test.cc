#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"
#include "support/sim/forged_state.hh"

namespace pongsim {
namespace {

std::string courtFile() { return (test::projectFolder() / "worlds/pong_world.sdf").string(); }

std::unique_ptr<Simulation> court(const SimulationOptions& options = {}) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromFile(courtFile(), options, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  return simulation;
}

void press(Simulation& simulation, int key) {
  Publisher keys = simulation.transport().node().advertise("/keyboard/keypress", "ignition.msgs.Int32");
  const MessagePointer message = newMessage("ignition.msgs.Int32");
  ASSERT_FALSE(parseMessage("data: " + std::to_string(key), *message).has_value());
  keys.publish(*message);
}

/// Drives forward, then along a curve until it stops at a wall.
std::uint64_t driveOn(Simulation& simulation) {
  press(simulation, 16777235);
  simulation.step(1500);
  press(simulation, 16777234);
  simulation.step(1500);
  return simulation.stateHash();
}

TEST(SavedState, GivesOneHashInTenRunsAfterAResetAndFromASave) {
  std::set<std::uint64_t> hashes;
  for (int i = 0; i < 10; ++i) {
    const auto simulation = court();
    ASSERT_NE(simulation, nullptr);
    simulation->step(500);
    hashes.insert(driveOn(*simulation));
  }
  const auto simulation = court();
  simulation->step(500);
  const std::vector<std::byte> state = simulation->saveState();
  hashes.insert(driveOn(*simulation));

  Diagnostics diagnostics;
  simulation->reset(diagnostics);
  simulation->step(500);
  hashes.insert(driveOn(*simulation));

  EXPECT_TRUE(simulation->restoreState(state));
  EXPECT_EQ(simulation->time(), std::chrono::milliseconds(500));
  hashes.insert(driveOn(*simulation));

  const auto other = court();
  EXPECT_TRUE(other->restoreState(state));
  hashes.insert(driveOn(*other));
  EXPECT_EQ(hashes.size(), 1U);
}

TEST(SavedState, IsTheSameOnThreadsOfTheirOwn) {
  const auto alone = court();
  const std::uint64_t expected = driveOn(*alone);
  std::vector<std::uint64_t> hashes(4);
  std::vector<std::thread> threads;
  for (std::uint64_t& hash : hashes) {
    threads.emplace_back([&hash] {
      const auto simulation = court();
      hash = driveOn(*simulation);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, expected);
}

TEST(SavedState, KeepsWhatWasChangedWhileRunning) {
  const auto simulation = court({.loadSystems = false});
  simulation->world().setGravity({0, 0, -1});
  simulation->setStepSize(std::chrono::milliseconds(2));
  simulation->step(10);
  const std::vector<std::byte> state = simulation->saveState();
  const auto other = court({.loadSystems = false});
  EXPECT_TRUE(other->restoreState(state));
  EXPECT_EQ(other->stepSize(), std::chrono::milliseconds(2));
  EXPECT_EQ(other->world().gravity(), Vector3(0, 0, -1));
  simulation->step(500);
  other->step(500);
  EXPECT_EQ(simulation->stateHash(), other->stateHash());
}

TEST(SavedState, KeepsJointsThatWereMadeAndRemoved) {
  constexpr const char* kArmAndCrate = R"(<sdf version="1.9"><world name="w"><model name="arm">
      <link name="base"><pose>0 0 2 0 0 0</pose></link><link name="hand"><pose>1 0 2 0 0 0</pose></link>
      <joint name="root" type="fixed"><parent>world</parent><child>base</child></joint>
      <joint name="elbow" type="revolute"><parent>base</parent><child>hand</child><axis><xyz>0 1 0</xyz></axis></joint>
    </model><model name="crate"><pose>1 0 1 0 0 0</pose><link name="link"/></model></world></sdf>)";
  const auto begin = [&] {
    Diagnostics diagnostics;
    auto simulation = Simulation::fromText(kArmAndCrate, "w.sdf", {.loadSystems = false}, diagnostics);
    simulation->step(50);
    return simulation;
  };
  const auto attachCrate = [](Simulation& simulation) {
    const Link hand = *simulation.world().model("arm")->link("hand");
    const Link crate = *simulation.world().model("crate")->link("link");
    const Outcome<Joint> made = simulation.world().attach(hand, crate, "leash");
    ASSERT_TRUE(made) << made.error;
    simulation.step(50);
  };
  const auto removeElbow = [](Simulation& simulation) {
    ASSERT_TRUE(simulation.world().detach(*simulation.world().model("arm")->joint("elbow")));
    simulation.step(50);
  };
  const auto simulation = begin();
  std::vector<std::vector<std::byte>> states;
  std::vector<std::uint64_t> futures;
  const auto future = [](Simulation& each) {
    each.step(300);
    return each.stateHash();
  };
  states.push_back(simulation->saveState());
  attachCrate(*simulation);
  states.push_back(simulation->saveState());
  removeElbow(*simulation);
  states.push_back(simulation->saveState());
  for (const std::vector<std::byte>& state : states) {
    const auto other = begin();
    EXPECT_TRUE(other->restoreState(state));
    futures.push_back(future(*other));
  }
  EXPECT_EQ(std::set(futures.begin(), futures.end()).size(), 3U);
  // restored repeatedly in one simulation; joints that were removed have to be made again
  for (const std::size_t i : {2U, 0U, 1U, 2U, 1U, 0U}) {
    EXPECT_TRUE(simulation->restoreState(states[i]));
    EXPECT_EQ(simulation->saveState(), states[i]);
    EXPECT_EQ(future(*simulation), futures[i]) << i;
  }
  // after an insertion, joints of the file can't be made again
  EXPECT_TRUE(simulation->restoreState(states[2]));
  Diagnostics diagnostics;
  ASSERT_TRUE(simulation->insertText("<sdf version='1.9'><model name='new'><link name='l'/></model></sdf>", "new.sdf",
                                     {}, diagnostics));
  EXPECT_FALSE(simulation->restoreState(states[0]));
}

// The list of joints is sorted by id.
TEST(SavedState, IsRefusedWhereAModelHasComeAnewSinceAJointWasMade) {
  constexpr const char* kTwoLinks = R"(<sdf version="1.9"><world name="w">
      <model name="a"><link name="l"/></model><model name="b"><pose>5 0 0 0 0 0</pose><link name="l"/></model>
    </world></sdf>)";
  constexpr const char* kPair = R"(<sdf version="1.9"><model name="pair"><pose>0 9 0 0 0 0</pose><link name="l"/>
      <link name="m"/><joint name="j" type="fixed"><parent>l</parent><child>m</child></joint></model></sdf>)";
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(kTwoLinks, "w.sdf", {.loadSystems = false}, diagnostics);
  ASSERT_TRUE(simulation->insertText(kPair, "pair.sdf", {}, diagnostics));
  const Link a = *simulation->world().model("a")->link("l");
  const Link b = *simulation->world().model("b")->link("l");
  const Outcome<Joint> leash = simulation->world().attach(a, b, "leash");
  ASSERT_TRUE(leash) << leash.error;
  const std::vector<std::byte> state = simulation->saveState();
  EXPECT_TRUE(simulation->restoreState(state));
  ASSERT_TRUE(simulation->remove(*simulation->world().model("pair")));
  ASSERT_TRUE(simulation->insertText(kPair, "pair.sdf", {}, diagnostics));
  EXPECT_FALSE(simulation->restoreState(state));
  EXPECT_TRUE(simulation->remove(*simulation->world().model("pair")));
  simulation->step(10);
}

TEST(SavedState, IsRefusedWhereItDoesNotFit) {
  const auto simulation = court({.loadSystems = false});
  simulation->step(100);
  std::vector<std::byte> state = simulation->saveState();
  const std::uint64_t hash = simulation->stateHash();
  const auto refusal = [&](const std::vector<std::byte>& bytes) { return simulation->restoreState(bytes).error; };
  EXPECT_EQ(refusal({}), "this is not a saved state");
  EXPECT_EQ(refusal(std::vector<std::byte>(100)), "the saved state is from another version of pongsim");
  EXPECT_EQ(refusal(std::vector<std::byte>(state.begin(), state.end() - 1)), "the saved state is damaged");
  std::vector<std::byte> damaged = state;
  damaged[100] ^= std::byte{1};
  EXPECT_EQ(refusal(damaged), "the saved state is damaged");
  const std::string otherWorld = "the saved state is of another world, or of other models, joints or systems";
  EXPECT_EQ(refusal(court()->saveState()), otherWorld);
  EXPECT_EQ(simulation->stateHash(), hash);
  EXPECT_TRUE(simulation->remove(*simulation->world().model("pong_bot")));
  EXPECT_EQ(refusal(state), otherWorld);
}

// A forged state can have a correct checksum.
TEST(SavedState, LeavesNoTraceWhereItIsRefused) {
  const auto simulation = court();
  press(*simulation, 16777235);
  simulation->step(500);
  const std::vector<std::byte> state = simulation->saveState();
  simulation->step(100);
  const std::vector<std::byte> present = simulation->saveState();
  std::mt19937_64 random(46);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    const Outcome<void> restored = simulation->restoreState(test::forged(state, random));
    if (restored) {
      // the forged values may make the simulation fail
      try {
        simulation->step(20);
      } catch (const std::runtime_error&) {
      }
    } else {
      ++refused;
      EXPECT_FALSE(restored.error.empty());
      ASSERT_EQ(simulation->saveState(), present) << i << ": " << restored.error;
    }
    ASSERT_TRUE(simulation->restoreState(present)) << i;
  }
  EXPECT_GT(refused, 250);
  EXPECT_LT(refused, 500);
  const std::uint64_t hash = driveOn(*simulation);
  EXPECT_TRUE(simulation->restoreState(present));
  EXPECT_EQ(driveOn(*simulation), hash);
}

// Joints of the file can't be made again after an insertion.
TEST(SavedState, TellsWhereItHasLeftATrace) {
  Diagnostics diagnostics;
  const auto begin = [&] {
    auto simulation = Simulation::fromText(R"(<sdf version="1.9"><world name="w"><model name="arm">
        <link name="base"/><link name="rod"/><joint name="hinge" type="revolute"><parent>base</parent><child>rod</child>
        <axis><xyz>0 0 1</xyz></axis></joint></model></world></sdf>)",
                                           "w.sdf", {.loadSystems = false}, diagnostics);
    EXPECT_TRUE(simulation->insertText("<sdf version='1.9'><model name='new'><link name='l'/></model></sdf>", "new.sdf",
                                       {}, diagnostics));
    return simulation;
  };
  const auto other = begin();
  EXPECT_TRUE(other->world().detach(*other->world().model("arm")->joint("hinge")));
  std::vector<std::byte> state = other->saveState();
  state.pop_back();
  const auto simulation = begin();
  EXPECT_EQ(
      simulation->restoreState(test::withChecksum(state)).error,
      "the saved state is invalid: it is truncated; what has been restored of it stays, because the saved state has "
      "joints that can't be recreated here");
  simulation->step(20);
  EXPECT_FALSE(simulation->world().model("arm")->joint("hinge"));
}

TEST(SavedState, IsRefusedWithTheReason) {
  const auto simulation = court({.loadSystems = false});
  std::vector<std::byte> state = simulation->saveState();
  state.push_back(std::byte{0});
  EXPECT_EQ(simulation->restoreState(test::withChecksum(state)).error, "the saved state is invalid: it is too long");
  state.resize(state.size() - 2);
  EXPECT_EQ(simulation->restoreState(test::withChecksum(state)).error, "the saved state is invalid: it is truncated");
}

}  // namespace
}  // namespace pongsim
