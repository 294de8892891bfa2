#include "log/system/log_playback.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/log_playback_stats.pb.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "log/playback/recorded_state.hh"
#include "log/tlog/tlog_reader.hh"
#include "support/fortress_worlds.hh"
#include "support/log/log_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

class LogPlaybackTest : public testing::Test {
 protected:
  fs::path recording() const { return folder_.path() / "rec"; }

  /// Records 30 steps of a pendulum; another one is inserted after 10 and removed after 20.
  void record() {
    const fs::path file = folder_.write(
        "w.sdf", test::worldText(test::pendulum("p", "0 0 2 0 0 0") +
                                 test::plugin("LogRecord", "<record_path>" + recording().string() + "</record_path>")));
    const std::unique_ptr<Simulation> simulation = test::load(file);
    std::optional<Model> second;
    for (int step = 1; step <= 30; ++step) {
      Diagnostics diagnostics;
      if (step == 11) {
        second = simulation->insertText("<sdf version='1.9'>" + test::pendulum("q", "1 0 2 0 0 0") + "</sdf>", "q", {},
                                        diagnostics);
        ASSERT_TRUE(second);
      }
      if (step == 21) {
        ASSERT_TRUE(simulation->remove(*second));
      }
      simulation->step();
      for (const Model& model : simulation->world().models())
        angles_[step][std::string(model.name())] = model.joint("hinge")->position();
    }
  }

  /// @return A world with only the player.
  std::unique_ptr<Simulation> play(const fs::path& path) {
    const fs::path file = folder_.write(
        "played.sdf", "<sdf version='1.9'><world name='w'>" +
                          test::plugin("LogPlayback", "<playback_path>" + path.string() + "</playback_path>") +
                          "</world></sdf>");
    return test::load(file, {.physics = false});
  }

  /// Makes all steps, and looks up the position of each model that exists at both ends of a step.
  void expectAll(Simulation& played) {
    for (int step = 1; step <= 30; ++step) {
      played.step();
      const std::map<std::string, double> angles = anglesIn(played);
      // between two steps, the models are those of the next step
      EXPECT_EQ(angles.contains("q"), angles_[std::min(step + 1, 30)].contains("q")) << step;
      for (const auto& [name, angle] : angles_[step]) {
        if (angles.contains(name)) {
          EXPECT_EQ(angles.at(name), angle) << step;
        }
      }
    }
  }

  /// @return Hinge angle of each pendulum [rad].
  static std::map<std::string, double> anglesIn(Simulation& simulation) {
    std::map<std::string, double> angles;
    for (const Model& model : simulation.world().models())
      angles[std::string(model.name())] = model.joint("hinge")->position();
    return angles;
  }

  std::map<int, std::map<std::string, double>> angles_;
  test::TempFolder folder_;
};

TEST_F(LogPlaybackTest, PlaysWhatWasRecordedWithWhoComesAndGoes) {
  record();
  const std::unique_ptr<Simulation> played = play(recording());
  expectAll(*played);
}

TEST_F(LogPlaybackTest, GoesToAnyTimeAndOnFromThere) {
  record();
  const std::unique_ptr<Simulation> played = play(recording());
  for (const int step : {25, 15, 5, 30, 1}) {
    EXPECT_TRUE(played->setTime(std::chrono::milliseconds(step)));
    played->stepPaused();
    EXPECT_EQ(anglesIn(*played), angles_[step]) << step;
    if (step == 30) continue;
    played->step();
    EXPECT_EQ(anglesIn(*played), angles_[step + 1]) << step;
  }
}

TEST_F(LogPlaybackTest, ARewoundPlaybackIsAsTheFirst) {
  record();
  const std::unique_ptr<Simulation> played = play(recording());
  played->step(30);
  Diagnostics diagnostics;
  played->reset(diagnostics);
  expectAll(*played);
}

TEST_F(LogPlaybackTest, TellsWhichTimesThereAre) {
  record();
  const std::unique_ptr<Simulation> played = play(recording());
  ignition::msgs::LogPlaybackStatistics range;
  const Subscription listener = played->transport().node().subscribe<ignition::msgs::LogPlaybackStatistics>(
      "/world/w/playback/stats", [&](const auto& message) { range = message; });
  played->transport().dispatch();
  EXPECT_EQ(range.start_time().nsec(), 1'000'000);
  EXPECT_EQ(range.end_time().nsec(), 30'000'000);
}

TEST_F(LogPlaybackTest, SeekingIsForPlaybacksOnly) {
  record();
  const std::unique_ptr<Simulation> simulated = test::load(folder_.path() / "w.sdf");
  EXPECT_FALSE(simulated->setTime(std::chrono::seconds(1)));
  EXPECT_EQ(simulated->time(), Time::zero());
}

TEST_F(LogPlaybackTest, HasThePosesOfFortresssLogBitForBit) {
  const std::optional<fs::path> data = test::goldenData();
  if (!data) GTEST_SKIP() << "no recordings of Fortress here";
  const fs::path log = *data / "log/double_pendulum.tlog";
  const std::unique_ptr<Simulation> played = play(log);
  const TlogReader reader(log);
  RecordedState state;
  std::size_t compared = 0;
  reader.forEach({.topics = reader.topicsOf("ignition.msgs.SerializedStateMap")}, [&](const Record& record) {
    EXPECT_TRUE(state.apply(record.type, record.payload));
    played->step();
    EXPECT_EQ(played->time().count(), record.timeNs);
    for (const std::uint64_t id : state.entitiesWith("Link")) {
      const std::uint64_t modelId = state.parentOf(id);
      const std::optional<Model> model = played->world().model(state.text(modelId, "Name"));
      EXPECT_TRUE(model.has_value());
      if (!model) return false;
      EXPECT_EQ(model->link(state.text(id, "Name"))->pose(), state.poseOf(modelId) * state.poseOf(id));
      ++compared;
    }
    return !HasFailure();
  });
  EXPECT_EQ(compared, 3000U * 4U);
}

TEST_F(LogPlaybackTest, WhatIsNoRecordingIsSaid) {
  Diagnostics diagnostics;
  const fs::path file = folder_.write(
      "none.sdf", test::worldText(test::plugin("LogPlayback", "<playback_path>/none/such</playback_path>")));
  const std::unique_ptr<Simulation> simulation = Simulation::fromFile(file, {}, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_NE(diagnostics.all()[0].message.find("there is no recording '/none/such'"), std::string::npos)
      << diagnostics.all()[0].message;
}

}  // namespace
}  // namespace pongsim::log
