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

/// Fails unless a saved state contains everything that the next steps depend on: restores the state of `world` in
/// `other`, which has the same content. After further steps both must have the same bits.
inline void expectSameBitsFromSavedState(RunningWorld& world, RunningWorld& other, std::uint64_t steps) {
  const std::vector<std::byte> state = world.simulation().saveState();
  ASSERT_TRUE(other.simulation().restoreState(state));
  world.step(steps);
  other.step(steps);
  EXPECT_EQ(other.simulation().stateHash(), world.simulation().stateHash());
}

/// As above. Both must also publish the same messages on a topic.
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

/// Fails unless a reset undoes everything: after a run, a reset, another run and another reset, the first run must lead
/// to the same bits again.
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
