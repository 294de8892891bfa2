// Runs recorded with `--record-inputs`, replayed and compared.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "integration/program.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

class Replay : public testing::Test {
 protected:
  static std::string contentOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// Runs the program, which must succeed.
  static std::string done(std::vector<std::string> arguments) {
    const Outcome outcome = runToEnd(std::move(arguments));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error << outcome.output;
    return outcome.output;
  }
  static void ask(const std::string& service, const std::string& request) {
    done({"service", "-s", "/world/pong_world/" + service, "--req", request});
  }
  static void drive(const char* velocity) {
    done({"topic", "-t", "/cmd_vel", "-m", "Twist", "-p", velocity, "--timeout", "60000"});
  }
  static void press(const std::string& keys) {
    Process process({"sh", "-c", "printf '" + keys + "' | '" PONGSIM_PROGRAM "' key --timeout 60000"});
    EXPECT_EQ(process.wait(), 0) << process.error();
  }

  /// Starts a client that publishes until it is killed.
  static std::unique_ptr<Process> startTalker() {
    return start({"topic", "-t", "/cmd_vel", "-m", "Twist", "-p", "linear: {x: 0.2}", "--rate", "500"});
  }

  /// @return The hash that `--hash` has printed.
  static std::string hashIn(const std::string& output) {
    const Regex::Match found = Regex("state hash: ([0-9a-f]{16})").firstIn(output);
    EXPECT_EQ(found.size(), 2U) << output;
    return found.size() == 2 ? found[1] : "";
  }

  /// A run of a few seconds with inputs of many kinds.
  /// @return Its hash at the end.
  std::string record(std::vector<std::string> options = {}) {
    options.insert(options.end(), {"--paused", "--hash", "--record-inputs", recording_});
    const std::unique_ptr<Process> run = startServedWorld("pong_world.sdf", options);
    done({"world", "step", "100"});
    drive("linear: {x: 0.5}");
    done({"world", "step", "250"});
    done({"world", "play"});
    const std::unique_ptr<Process> talker = startTalker();
    press("\\033[A\\033[C");
    ask("create", R"(clone_name: "pong_bot", name: "twin", pose {position {y: 2, z: 1}})");
    press("\\033[D");
    ask("set_pose", R"(name: "twin", position {x: 1, y: 1, z: 0.5})");
    done({"world", "reset"});
    drive("linear: {x: 0.4}, angular: {z: 0.8}");
    ask("create", R"(clone_name: "pong_bot", name: "other", pose {position {y: -2, z: 1}})");
    talker->kill(SIGKILL);
    talker->wait();
    ask("remove", R"(name: "other", type: MODEL)");
    done({"world", "reset", "--seed", "9"});
    drive("linear: {x: -0.4}");
    done({"world", "pause"});
    done({"world", "step", "77"});
    run->kill(SIGINT);
    EXPECT_EQ(run->wait(), 0) << run->error();
    EXPECT_EQ(run->error().find("error"), std::string::npos) << run->error();
    return hashIn(run->output());
  }

  const TempFolder folder_;
  const std::string recording_ = folder_.path() / "run.inputs";
};

TEST_F(Replay, HasTheBitsOfTheRunOnAnyNumberOfThreads) {
  const std::string hash = record();
  for (const char* threads : {"1", "2", "4"}) {
    const std::string output = done({"replay", recording_, "--threads", threads});
    EXPECT_NE(output.find("world 'pong_world' is as recorded up to step "), std::string::npos) << output;
    EXPECT_NE(output.find("state hash " + hash), std::string::npos) << output << hash;
  }
}

TEST_F(Replay, HasTheBitsOfARunOnThreadsAsFastAsPossible) {
  const std::string hash = record({"--threads", "3", "-z", "0"});
  const std::string output = done({"replay", recording_});
  EXPECT_NE(output.find("state hash " + hash), std::string::npos) << output << hash;
}

TEST_F(Replay, StopsForALook) {
  done({"run", ownWorld("pong_world.sdf"), "-z", "0", "--iterations", "500", "--record-inputs", recording_});
  const std::string output = done({"replay", recording_, "--until", "200"});
  EXPECT_NE(output.find("is as recorded up to step 200 (0.2 s)"), std::string::npos) << output;
  EXPECT_NE(output.find("link pong_bot::"), std::string::npos) << output;
  EXPECT_NE(output.find("  position x: "), std::string::npos) << output;
  EXPECT_EQ(done({"run", ownWorld("pong_world.sdf"), "-z", "0", "--iterations", "200", "--hash"}),
            "state hash: " + Regex("state hash ([0-9a-f]{16})").firstIn(output)[1] + "\n");
}

TEST_F(Replay, GoesOnLivePaused) {
  done({"run", ownWorld("pong_world.sdf"), "-z", "0", "--iterations", "500", "--record-inputs", recording_});
  const std::unique_ptr<Process> live = start({"replay", recording_, "--until", "200", "--live", "--paused"});
  ASSERT_TRUE(live->waitForError("goes on with the network, paused")) << live->error();
  done({"world", "step", "300", "--timeout", "60000"});
  const std::string stats = done({"world", "stats", "-n", "1", "--timeout", "60000"});
  EXPECT_NE(stats.find("500"), std::string::npos) << stats;
  live->kill(SIGINT);
  EXPECT_EQ(live->wait(), 0) << live->error();
}

TEST_F(Replay, ReplaysUpToWhereTheRecordingIsCutOff) {
  done({"run", ownWorld("pong_world.sdf"), "-z", "0", "--iterations", "5000", "--record-inputs", recording_});
  const auto size = std::filesystem::file_size(recording_);
  std::filesystem::resize_file(recording_, size - 4000);
  const Outcome outcome = runToEnd({"replay", recording_});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("it is cut off or damaged after "), std::string::npos) << outcome.error;
  const Regex::Match steps = Regex("is as recorded up to step ([0-9]+) ").firstIn(outcome.output);
  ASSERT_EQ(steps.size(), 2U) << outcome.output;
  EXPECT_GT(std::stoi(steps[1]), 1000);
  EXPECT_LT(std::stoi(steps[1]), 5000);
}

TEST_F(Replay, EndsWithTheReasonWhereTheDiskIsFull) {
  testDomain();
  Process run({"sh", "-c",
               "trap '' XFSZ; ulimit -f 40; exec '" PONGSIM_PROGRAM "' run '" + ownWorld("pong_world.sdf") +
                   "' -z 0 --iterations 1000000 --record-inputs '" + recording_ + "'"});
  EXPECT_EQ(run.wait(), 1) << run.error();
  EXPECT_NE(run.error().find("can't record inputs in '" + recording_ + "': File too large"), std::string::npos)
      << run.error();
}

TEST_F(Replay, FindsAChangedInertiaWithItsStepAndField) {
  const std::string before = contentOf(ownWorld("pong_world.sdf"));
  const auto world = folder_.write("world.sdf", before);
  const std::unique_ptr<Process> run =
      start({"run", world.string(), "-z", "0", "--paused", "--record-inputs", recording_});
  done({"world", "step", "500", "--timeout", "60000"});
  drive("linear: {x: 0.5}");
  done({"world", "step", "500"});
  run->kill(SIGINT);
  EXPECT_EQ(run->wait(), 0) << run->error();

  std::string after = before;
  const std::size_t place = after.find("<izz>") + 5;
  after.replace(place, after.find('<', place) - place, "7.5");
  const auto changed = folder_.write("world.sdf", after);
  const Outcome outcome = runToEnd({"replay", recording_});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.error.find("inertia, izz: '"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("and '7.5'"), std::string::npos) << outcome.error;
  const Regex found(
      "world 'pong_world' differs from step ([0-9]+) on \\([0-9.]+ s\\):\n  link 'pong_bot::[a-z_]+', .*: .* and ");
  const Regex::Match match = found.firstIn(outcome.output);
  ASSERT_EQ(match.size(), 2U) << outcome.output;

  // the same by the other command, from the recording
  const Outcome bisected = runToEnd({"bisect", recording_, changed.string()});
  EXPECT_EQ(bisected.exitCode, 1) << bisected.error;
  EXPECT_NE(bisected.output.find("differs from step " + match[1] + " on"), std::string::npos) << bisected.output;
}

TEST_F(Replay, RunsTheRecordedWorldWhereTheFileIsGone) {
  const auto world = folder_.write("world.sdf", contentOf(ownWorld("pong_world.sdf")));
  done({"run", world.string(), "-z", "0", "--iterations", "300", "--record-inputs", recording_});
  std::filesystem::remove(world);
  const Outcome outcome = runToEnd({"replay", recording_});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error << outcome.output;
  EXPECT_NE(outcome.error.find("the world is taken from the recording"), std::string::npos) << outcome.error;
}

TEST_F(Replay, ReplaysAllWorldsOfAFile) {
  done({"run", ownWorld("three_worlds.sdf"), "-z", "0", "--iterations", "500", "--record-inputs", recording_});
  const std::string output = done({"replay", recording_});
  for (const char* world : {"fine", "coarse", "fast"}) {
    EXPECT_NE(output.find("world '" + std::string(world) + "' is as recorded up to step 500 "), std::string::npos)
        << output;
  }
}

TEST_F(Replay, RefusesWhatIsNoRecording) {
  const Outcome other = runToEnd({"replay", ownWorld("pong_world.sdf")});
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_NE(other.error.find("is not a recording of inputs"), std::string::npos) << other.error;
  EXPECT_EQ(runToEnd({"replay", (folder_.path() / "none").string()}).exitCode, 1);
  EXPECT_EQ(runToEnd({"replay"}).exitCode, 2);
  EXPECT_EQ(runToEnd({"replay", recording_, "--paused"}).exitCode, 2);
  EXPECT_EQ(runToEnd({"run", "--record-inputs", "/nowhere/run.inputs", "--iterations", "1"}).exitCode, 1);
}

TEST_F(Replay, ComparesTwoWorlds) {
  const std::string text = contentOf(ownWorld("pong_world.sdf"));
  const auto a = folder_.write("a.sdf", text);
  const auto b =
      folder_.write("b.sdf", "<!-- the same -->" + text.substr(text.find("?>") == text.npos ? 0 : text.find("?>") + 2));
  const std::string same = done({"bisect", a.string(), b.string(), "--steps", "300"});
  EXPECT_EQ(same, "world 'pong_world' has the same bits up to step 300 (0.3 s)\n");
  EXPECT_EQ(runToEnd({"bisect", a.string(), ownWorld("three_worlds.sdf")}).exitCode, 1);
  EXPECT_EQ(runToEnd({"bisect", a.string()}).exitCode, 2);
}

}  // namespace
}  // namespace pongsim::test
