#include "sim/running/run_history.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/log_playback_stats.pb.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/simulation.hh"

namespace pongsim::sim {
namespace {

using std::chrono::milliseconds;

std::string ball(const std::string& name) {
  return "<model name='" + name +
         "'><pose>0 0 9 0 0 0</pose><link name='l'><inertial><mass>1</mass></inertial></link></model>";
}

class RunHistoryTest : public testing::Test {
 protected:
  RunHistoryTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><physics name='p' type='ignored'><max_step_size>0.01</max_step_size>"
        "</physics>" +
            ball("a") + "</world></sdf>",
        "world.sdf", {.loadSystems = false}, diagnostics);
    history_.emplace(*simulation_, true);
  }

  void listen() {
    listener_ = simulation_->transport().node().subscribe<ignition::msgs::LogPlaybackStatistics>(
        "/world/w/playback/stats", [this](const auto& range) { range_ = range; });
  }

  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      simulation_->step();
      history_->stepped();
      hashes_[simulation_->time()] = simulation_->stateHash();
    }
  }

  /// @return First and last time that can be sought, as published [ms].
  std::pair<std::int64_t, std::int64_t> range() {
    now_ += milliseconds(100);
    history_->publishRange(now_);
    simulation_->transport().dispatch();
    const auto ms = [](const ignition::msgs::Time& time) { return time.sec() * 1000 + time.nsec() / 1'000'000; };
    return {ms(range_.start_time()), ms(range_.end_time())};
  }

  std::unique_ptr<Simulation> simulation_;
  std::optional<RunHistory> history_;
  Subscription listener_;
  ignition::msgs::LogPlaybackStatistics range_;
  std::map<Time, std::uint64_t> hashes_;
  std::chrono::steady_clock::time_point now_;
};

TEST_F(RunHistoryTest, GoesToTheLastStateBeforeATime) {
  listen();
  run(300);
  EXPECT_EQ(range(), std::pair(std::int64_t{10}, std::int64_t{3000}));
  ASSERT_TRUE(history_->goTo(milliseconds(1700)));
  EXPECT_EQ(simulation_->time(), milliseconds(1510));
  EXPECT_EQ(simulation_->stateHash(), hashes_.at(milliseconds(1510)));
  // what came later can be sought until it goes on
  EXPECT_EQ(range(), std::pair(std::int64_t{10}, std::int64_t{2510}));
  ASSERT_TRUE(history_->goTo(milliseconds(3000)));
  EXPECT_EQ(simulation_->time(), milliseconds(2510));
}

TEST_F(RunHistoryTest, ForgetsWhatComesAfterWhereItGoesOn) {
  listen();
  run(300);
  ASSERT_TRUE(history_->goTo(milliseconds(1000)));
  const auto before = hashes_;
  run(100);
  EXPECT_EQ(range(), std::pair(std::int64_t{10}, std::int64_t{1510}));
  EXPECT_EQ(hashes_, before);
}

TEST_F(RunHistoryTest, KeepsNothingThatNobodyWants) {
  run(300);
  const Outcome<void> gone = history_->goTo(milliseconds(2000));
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error,
            "no state of that time is kept: the last minute is, while somebody listens to /world/w/playback/stats "
            "and the run's inputs are not recorded");
  listen();
  run(100);
  EXPECT_FALSE(history_->goTo(milliseconds(3000)));
  EXPECT_TRUE(history_->goTo(milliseconds(3020)));
  listener_ = {};
  run(1);
  EXPECT_FALSE(history_->goTo(milliseconds(9000)));
}

TEST_F(RunHistoryTest, KeepsNothingWhereInputsAreRecorded) {
  history_.emplace(*simulation_, false);
  listen();
  run(100);
  EXPECT_FALSE(history_->goTo(milliseconds(500)));
}

TEST_F(RunHistoryTest, KeepsAMinute) {
  listen();
  run(7000);
  EXPECT_EQ(range(), std::pair(std::int64_t{10'010}, std::int64_t{70'000}));
}

TEST_F(RunHistoryTest, DoesNotReturnToOtherModels) {
  listen();
  run(100);
  Diagnostics diagnostics;
  ASSERT_TRUE(simulation_->insertText("<sdf version='1.9'>" + ball("b") + "</sdf>", "b", {}, diagnostics));
  run(100);
  EXPECT_FALSE(history_->goTo(milliseconds(600)));
  EXPECT_EQ(simulation_->time(), milliseconds(2000));
  EXPECT_TRUE(history_->goTo(milliseconds(2000)));
  EXPECT_EQ(range().first, 1010);
}

TEST_F(RunHistoryTest, LeavesRecordingsToThemselves) {
  Diagnostics diagnostics;
  const auto played = Simulation::fromText("<sdf version='1.9'><world name='w'/></sdf>", "world.sdf",
                                           {.loadSystems = false, .physics = false}, diagnostics);
  const RunHistory history(*played, true);
  EXPECT_TRUE(played->transport().node().ownTopics().empty());
}

}  // namespace
}  // namespace pongsim::sim
