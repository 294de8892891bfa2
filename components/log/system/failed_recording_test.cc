// A recording that can't be written, as on a full disk: the run says so and fails.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "log/tlog/tlog_reader.hh"
#include "log/tlog/tlog_writer.hh"
#include "support/file_size_limit.hh"
#include "support/log/log_support.hh"
#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kFull = 3'000'000;
/// Steps that record more than that.
constexpr std::uint64_t kSteps = 4000;

class FailedRecording : public testing::Test {
 protected:
  FailedRecording() { test::testDomain(); }

  fs::path recording() const { return folder_.path() / "rec"; }

  static std::string pendulums() {
    std::string models;
    for (int i = 0; i < 20; ++i)
      models += test::pendulum("p" + std::to_string(i), "0 " + std::to_string(2 * i) + " 2 0 0 0");
    return models;
  }
  /// A world with its own recorder.
  fs::path recordedWorld(const std::string& parameters = {}) {
    return folder_.write(
        "w.sdf", test::worldText(pendulums() + test::plugin("LogRecord", "<record_path>" + recording().string() +
                                                                             "</record_path>" + parameters)));
  }
  /// Runs a world of several pendulums with `--record-path` on a disk that gets full.
  std::unique_ptr<test::Process> run(const fs::path& world, const std::vector<std::string>& more) const {
    std::vector<std::string> words{PONGSIM_PROGRAM,     "run", world.string(), "-z", "0", "--record-path",
                                   recording().string()};
    words.insert(words.end(), more.begin(), more.end());
    // the limit and the ignored signal are inherited
    const test::FileSizeLimit full(kFull);
    auto process = std::make_unique<test::Process>(words);
    EXPECT_TRUE(process->wait().has_value());
    return process;
  }
  static std::size_t messagesIn(const fs::path& folder) {
    std::size_t sum = 0;
    for (const Topic& each : TlogReader(folder / "state.tlog").topics()) sum += each.count;
    return sum;
  }
  static std::string incomplete(const fs::path& folder) {
    return "the recording is incomplete: '" + (folder / "state.tlog").string() +
           "' can't be written: disk I/O error; " + std::to_string(messagesIn(folder)) + " messages are kept";
  }

  test::TempFolder folder_;
};

TEST_F(FailedRecording, EndsTheRunWithAnErrorAfterAllSteps) {
  const fs::path world = folder_.write("w.sdf", test::worldText(pendulums()));
  const auto done = run(world, {"--iterations", std::to_string(kSteps), "--hash"});
  EXPECT_EQ(done->wait(), 1);
  EXPECT_NE(done->error().find("pongsim: error: log: " + incomplete(recording())), std::string::npos) << done->error();
  EXPECT_NE(done->output().find("state hash"), std::string::npos) << done->output();
  EXPECT_GT(messagesIn(recording()), 100U);
}

TEST_F(FailedRecording, EndsAStrictRunAtOnce) {
  const fs::path world = folder_.write("w.sdf", test::worldText(pendulums()));
  const auto done = run(world, {"--strict"});
  EXPECT_EQ(done->wait(), 1);
  EXPECT_NE(done->error().find(incomplete(recording())), std::string::npos) << done->error();
}

TEST_F(FailedRecording, IsSaidForEachWorld) {
  const auto world = [](const std::string& name) { return "<world name='" + name + "'>" + pendulums() + "</world>"; };
  const fs::path file = folder_.write("two.sdf", "<sdf version='1.9'>" + world("w") + world("v") + "</sdf>");
  const auto done = run(file, {"--iterations", std::to_string(kSteps)});
  EXPECT_EQ(done->wait(), 1);
  for (const char* name : {"w", "v"}) {
    EXPECT_NE(
        done->error().find("pongsim: error: log (world " + std::string(name) + "): " + incomplete(recording() / name)),
        std::string::npos)
        << done->error();
  }
}

TEST_F(FailedRecording, IsOneOfAFolderThatCantBeMade) {
  const fs::path world = folder_.write("w.sdf", test::worldText(""));
  folder_.write("rec", "a file");
  const auto done = std::make_unique<test::Process>(std::vector<std::string>{
      PONGSIM_PROGRAM, "run", world.string(), "--iterations", "5", "--record-path", (recording() / "inside").string()});
  EXPECT_EQ(done->wait(), 1);
  EXPECT_NE(done->error().find("can't be created"), std::string::npos) << done->error();
}

TEST_F(FailedRecording, StaysOneAfterAResetAndARestoredState) {
  const auto simulation = test::load(recordedWorld());
  const std::vector<std::byte> state = simulation->saveState();
  const test::FileSizeLimit full(kFull);
  std::string said;
  EXPECT_TRUE(test::waitUntil([&] {
    testing::internal::CaptureStderr();
    simulation->step(100);
    said += testing::internal::GetCapturedStderr();
    return said.find("it is switched off") != std::string::npos;
  }));
  EXPECT_NE(said.find("error: log: failed in postUpdate: " + incomplete(recording())), std::string::npos) << said;
  Diagnostics diagnostics;
  simulation->reset(diagnostics);
  simulation->step(10);
  EXPECT_TRUE(simulation->restoreState(state));
  simulation->step(10);
  EXPECT_EQ(simulation->finish().error.find("log: " + incomplete(recording())), 0U) << simulation->finish().error;
  EXPECT_FALSE(simulation->finish());
}

TEST_F(FailedRecording, MayFailWhenItIsCompleted) {
  const auto simulation = test::load(recordedWorld("<compress>true</compress><compress_path>" +
                                                   (folder_.path() / "none/rec.zip").string() + "</compress_path>"));
  simulation->step(10);
  const std::string error = simulation->finish().error;
  EXPECT_NE(error.find("log: the recording is incomplete: '" + (folder_.path() / "none/rec.zip").string()),
            std::string::npos)
      << error;
  EXPECT_EQ(messagesIn(recording()), 11U);
}

TEST_F(FailedRecording, WithoutAStateIsNotPlayed) {
  {
    TlogWriter writer(folder_.path() / "state.tlog");
    writer.write({1, "/rec/sdf", "ignition.msgs.StringMsg", "\x12\x07<world>"});
    writer.close();
  }
  const auto done = std::make_unique<test::Process>(std::vector<std::string>{
      PONGSIM_PROGRAM, "run", "--playback", (folder_.path() / "state.tlog").string(), "--iterations", "5"});
  EXPECT_EQ(done->wait(), 1);
  EXPECT_NE(done->error().find("contains no state of a world"), std::string::npos) << done->error();
}

TEST_F(FailedRecording, IsNoneWhereAllIsWritten) {
  const auto simulation = test::load(recordedWorld());
  simulation->step(10);
  EXPECT_EQ(simulation->finish().error, "");
  EXPECT_EQ(messagesIn(recording()), 11U);
}

}  // namespace
}  // namespace pongsim::log
