#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::test {

/// Fails unless a state takes all with it that the next steps depend on: `other`, of the same content, is given that of
/// `world`, and both must then come to the same bits.
inline void expectSameBitsFromSavedState(RunningWorld& world, RunningWorld& other, std::uint64_t steps) {
  const std::vector<std::byte> state = world.simulation().saveState();
  ASSERT_EQ(other.simulation().restoreState(state), std::nullopt);
  world.step(steps);
  other.step(steps);
  EXPECT_EQ(other.simulation().stateHash(), world.simulation().stateHash());
}

/// As above, and both must say the same on a topic.
template <class M>
void expectSameBitsFromSavedState(RunningWorld& world, RunningWorld& other, std::uint64_t steps,
                                  const std::string& topic) {
  const auto listenTo = [&topic](RunningWorld& which, std::vector<std::string>& told) {
    return which.simulation().transport().node().subscribe<M>(
        topic, [&told](const M& message) { told.push_back(message.SerializeAsString()); });
  };
  std::vector<std::string> here, there;
  const Subscription ofWorld = listenTo(world, here), ofOther = listenTo(other, there);
  expectSameBitsFromSavedState(world, other, steps);
  EXPECT_FALSE(here.empty());
  EXPECT_EQ(here, there);
}

inline void resetWorld(RunningWorld& world) {
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
}

/// Fails unless a reset takes back all that has been: the world is run, reset, run in another way, and reset, after
/// which the first way must lead to the same bits again.
inline void expectToBeginAnewAfterReset(RunningWorld& world, const std::function<void()>& run,
                                        const std::function<void()>& runOtherwise) {
  run();
  const std::uint64_t hash = world.simulation().stateHash();
  resetWorld(world);
  runOtherwise();
  EXPECT_NE(world.simulation().stateHash(), hash) << "both ways are the same";
  resetWorld(world);
  run();
  EXPECT_EQ(world.simulation().stateHash(), hash);
}

}  // namespace pongsim::test
